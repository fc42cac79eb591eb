//! What bounding volumes promise: never to miss what they enclose.

mod boxes;
mod fours;
mod misses;
mod oriented;
mod polytopes;
mod slabs;
mod tools;

//! What bounding volumes promise: never to miss what they enclose.

mod boxes;
mod misses;
mod oriented;
mod pairs;
mod polytopes;
mod slabs;
mod tools;

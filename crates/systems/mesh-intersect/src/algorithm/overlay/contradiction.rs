//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that fails because signs contradict each other.
    pub enum Contradiction {
        Region: "a face is in one region of the other mesh", "a face is in two regions of the other mesh";
        NoArea: "a triangle has an area in a coordinate plane", "a triangle has no area in any coordinate plane";
        VertexRegion: "a vertex is in one region of the other mesh", "a vertex is in two regions of the other mesh";
        Apart: "an edge and a triangle that are registered have boxes that meet", "an edge and a triangle are registered whose boxes do not meet";
        Chain: "segments in a triangle are chains and rings", "segments in a triangle are not chains and rings";
        Ends: "the ends of an edge that passes through a triangle are on two sides of it", "the ends of an edge that passes through a triangle are on one side of it";
        Simplices: "the triangles of a mesh are simplices", "a triangle of a mesh is not a simplex";
        Segment: "two triangles meet in one segment", "two triangles do not meet in one segment";
        OneRegion: "vertices that no triangle parts are in one region", "vertices that no triangle parts are in two regions";
    }
    or {
        /// A face is not triangulated.
        Triangulation(predicament_triangulate::algorithm::Contradiction);
        /// An arrangement in a plane contradicts itself.
        Arrangement(predicament_overlay::algorithm::overlay::Contradiction);
        /// A result, or its limit, is not a surface.
        Surface(SurfaceContradiction);
    }
}

contradiction! {
    /// An invariant of limits and of resolved surfaces that fails.
    pub enum SurfaceContradiction {
        Plane: "a plane of doubles is a scene", "a plane of doubles is not a scene";
        Planar: "no point is inside of an edge, and no two edges cross", "a point is inside of an edge, or two edges cross";
        PartsClosed: "the parts of a closed surface that others have cut are closed", "the parts of a closed surface that others have cut are not closed";
        Faces: "faces meet in common corners and edges only", "faces meet not only in common corners and edges";
        Point: "each constructed vertex is a point where the meshes are", "a constructed vertex is not a point where the meshes are";
        Flat: "a closed mesh is not in one plane", "a closed mesh is in one plane";
        LimitClosed: "the limit of a closed surface is closed", "the limit of a closed surface is not closed";
    }
}

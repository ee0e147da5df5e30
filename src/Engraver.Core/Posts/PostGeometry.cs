namespace Engraver.Core.Posts;

/// <summary>The input of a post.</summary>
public enum PostGeometry
{
    /// <summary>A motion program in counts, made for the machine of the profile.</summary>
    Program,

    /// <summary>Curves as drawn, millimetres: an ellipse stays an ellipse.</summary>
    Curves,

    /// <summary>Lines, arcs and circles, millimetres; those of an ellipse or spline within the curve tolerance.</summary>
    LinesAndArcs,
}

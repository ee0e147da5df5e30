namespace Engraver.Core.Drawings;

/// <summary>Construction that is cut at the operator's request (<c>--cut</c>); without it, construction is only counted.</summary>
[Flags]
public enum CutChoice
{
    None = 0,

    /// <summary>The boundaries of HATCH, not its pattern.</summary>
    Hatch = 1,

    /// <summary>The element lines of MLINE with their caps and joints.</summary>
    MLine = 2,

    /// <summary>The line or spline of LEADER, without arrow head and hook.</summary>
    Leader = 4,

    /// <summary>HELIX, in plan view.</summary>
    Helix = 8,

    /// <summary>The edges of SOLID, TRACE and 3DFACE.</summary>
    Solid = 16,

    /// <summary>The letters of TEXT, MTEXT and ATTRIB. They are read in any case; a stage of the job makes curves of them.</summary>
    Text = 32,

    /// <summary>DIMENSION as its block draws it: lines, and with the other choices its arrow heads and text.</summary>
    Dimension = 64,
}

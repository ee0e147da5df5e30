namespace Engraver.Core.Machines.Origins;

/// <summary>The edge of a work piece that the tool touches from outside.</summary>
public enum WorkEdge
{
    /// <summary>The tool is at smaller X than the work piece.</summary>
    Left,

    /// <summary>The tool is at smaller Y than the work piece.</summary>
    Bottom,

    /// <summary>The tool is at larger X than the work piece.</summary>
    Right,

    /// <summary>The tool is at larger Y than the work piece.</summary>
    Top,
}

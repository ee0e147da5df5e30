namespace Engraver.Core.Machines;

/// <summary>How the segments of a stroke are grouped into sequences; it decides from which point the arcs of a sequence are computed.</summary>
public enum MotionStyle : byte
{
    /// <summary>A sequence continues up to a sharp corner (stream, program).</summary>
    Continuous,

    /// <summary>Every segment is a separate sequence: the paper's calls of #LINEAR and #CIRC, with a standstill after each.</summary>
    Calls,
}

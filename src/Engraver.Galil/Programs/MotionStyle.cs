namespace Engraver.Galil.Programs;

/// <summary>How the segments of a stroke are put into sequences; what a sequence starts from decides how its arcs are aimed.</summary>
public enum MotionStyle : byte
{
    /// <summary>Sequences go on until a sharp corner (stream, program).</summary>
    Continuous,

    /// <summary>Every segment is a sequence of its own: the paper's calls of #LINEAR and #CIRC, with a standstill after each.</summary>
    Calls,
}

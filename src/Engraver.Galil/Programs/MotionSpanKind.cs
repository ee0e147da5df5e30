namespace Engraver.Galil.Programs;

/// <summary>What the machine does in a span of planned time.</summary>
public enum MotionSpanKind : byte
{
    /// <summary>It stands: commands are exchanged, or the tool settles.</summary>
    Dwell,

    /// <summary>It moves between strokes with the tool off, each axis on its own.</summary>
    Rapid,

    /// <summary>It runs a vector sequence.</summary>
    Cut,
}

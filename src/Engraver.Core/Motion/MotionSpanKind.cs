namespace Engraver.Core.Motion;

/// <summary>What the machine does in a span of planned time.</summary>
public enum MotionSpanKind : byte
{
    /// <summary>At rest: commands are exchanged, or the tool settles.</summary>
    Dwell,

    /// <summary>Moves between strokes with the tool off, each axis independently.</summary>
    Rapid,

    /// <summary>Runs a vector sequence.</summary>
    Cut,
}

using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>A stretch of planned time in which the machine does one thing.</summary>
/// <param name="Kind">What.</param>
/// <param name="Start">Seconds since the job began.</param>
/// <param name="Seconds">How long.</param>
/// <param name="Stroke">Place of the stroke in the motion program.</param>
/// <param name="Sequence">Place of the sequence in its stroke that is cut or comes next.</param>
/// <param name="From">Where it begins, counts of the job frame.</param>
/// <param name="To">Where it ends.</param>
/// <param name="ToolOn">The tool output is on in it.</param>
public readonly record struct MotionSpan(MotionSpanKind Kind, double Start, double Seconds, int Stroke, int Sequence, CountsPoint From, CountsPoint To, bool ToolOn)
{
    public double End => Start + Seconds;
}

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

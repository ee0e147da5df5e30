using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>A period of planned time in which the machine does one thing.</summary>
/// <param name="Kind">What the machine does.</param>
/// <param name="Start">Seconds since the job began.</param>
/// <param name="Seconds">Duration.</param>
/// <param name="Stroke">Index of the stroke in the motion program.</param>
/// <param name="Sequence">Index in its stroke of the sequence that is cut or is next.</param>
/// <param name="From">Position at the beginning, counts of the job frame.</param>
/// <param name="To">Position at the end.</param>
/// <param name="ToolOn">The tool output is on.</param>
public readonly record struct MotionSpan(MotionSpanKind Kind, double Start, double Seconds, int Stroke, int Sequence, CountsPoint From, CountsPoint To, bool ToolOn)
{
    public double End => Start + Seconds;
}

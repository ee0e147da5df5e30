using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Posting;

/// <summary>One program of a job that does not fit the controller's memory at once.</summary>
/// <param name="Text">Complete with its subprograms; ends with a line end (LF).</param>
/// <param name="Parts">The strokes that it cuts, in order; a stroke longer than the memory is divided into several parts, each in a separate chunk.</param>
internal sealed record ProgramChunk(string Text, IReadOnlyList<MotionStroke> Parts)
{
    /// <summary>Every segment in the order of cutting, which is the order of the VP and CR commands in the text.</summary>
    public IEnumerable<VectorSegment> Segments => Parts.SelectMany(part => part.Sequences).SelectMany(sequence => sequence.Segments);
}

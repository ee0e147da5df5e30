using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The spans of a motion program as a column, 13 bytes each: duration, and the part of the sequence. The start and end point of a span are read from
/// the program on access.</summary>
internal sealed class SpanColumn(MotionProgram program, int[] firstSequences) : IndexedList<MotionSpan>
{
    /// <summary>Interval, in spans, at which start times are stored; those between are added up again, by the same sums.</summary>
    private const int Stride = 16;

    private const int PartBits = 4;

    private readonly List<double> _seconds = new((2 * firstSequences[^1]) + (4 * firstSequences.Length));
    private readonly List<int> _places = new((2 * firstSequences[^1]) + (4 * firstSequences.Length));
    private readonly List<double> _starts = [];

    /// <summary>Parts of a stroke in time, in their order.</summary>
    internal enum SpanPart
    {
        /// <summary>The tool is raised from its present height.</summary>
        Raise,
        Wait,
        Rapid,
        Load,
        ToolOn,
        Cut,

        /// <summary>The tool waits at the end of the stroke.</summary>
        Dwell,
        ToolOff,

        /// <summary>The move to the finish of the program.</summary>
        Finish,
    }

    public override int Count => _seconds.Count;

    /// <summary>The end of the last span.</summary>
    public double End { get; private set; }

    /// <param name="sequence">Index among the sequences of all strokes.</param>
    public void Add(SpanPart part, double seconds, int sequence)
    {
        if (Count % Stride == 0) _starts.Add(End);
        _seconds.Add(seconds);
        _places.Add((sequence << PartBits) | (int)part);
        End += seconds;
    }

    /// <summary>The last span that begins at a time or before it; 0 before the first, -1 when there is none.</summary>
    public int At(double seconds)
    {
        if (Count == 0) return -1;
        var (low, high) = (0, _starts.Count - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_starts[middle] <= seconds) low = middle;
            else high = middle - 1;
        }

        var (index, start) = (low * Stride, _starts[low]);
        var last = Math.Min(index + Stride, Count) - 1;
        while (index < last && start + _seconds[index] <= seconds) start += _seconds[index++];
        return index;
    }

    /// <summary>The same items; the start times are added up once.</summary>
    public override IEnumerator<MotionSpan> GetEnumerator()
    {
        var start = 0.0;
        for (var i = 0; i < Count; i++)
        {
            yield return Span(i, start);
            start += _seconds[i];
        }
    }

    protected override MotionSpan ItemAt(int index) => Span(index, StartOf(index));

    private double StartOf(int index)
    {
        var at = index - (index % Stride);
        var start = _starts[index / Stride];
        while (at < index) start += _seconds[at++];
        return start;
    }

    private MotionSpan Span(int index, double start)
    {
        var (part, sequence) = ((SpanPart)(_places[index] & ((1 << PartBits) - 1)), _places[index] >> PartBits);
        var stroke = Array.BinarySearch(firstSequences, sequence);
        if (stroke < 0) stroke = ~stroke - 1;
        var within = sequence - firstSequences[stroke];
        var (from, to) = PlacesOf(part, stroke, within);
        return new MotionSpan(KindOf(part), start, _seconds[index], stroke, within, from, to, part is SpanPart.ToolOn or SpanPart.Cut or SpanPart.Dwell || (part == SpanPart.Load && within > 0));
    }

    private static MotionSpanKind KindOf(SpanPart part) => part switch
    {
        SpanPart.Cut => MotionSpanKind.Cut,
        SpanPart.Rapid or SpanPart.Finish => MotionSpanKind.Rapid,
        _ => MotionSpanKind.Dwell,
    };

    private (CountsPoint From, CountsPoint To) PlacesOf(SpanPart part, int stroke, int sequence)
    {
        var cut = program.Strokes[stroke].Sequences[sequence];
        return part switch
        {
            SpanPart.Raise => (program.Start, program.Start),
            SpanPart.Wait => (Before(stroke), Before(stroke)),
            SpanPart.Rapid => (Before(stroke), program.Strokes[stroke].Start),
            SpanPart.Cut => (cut.Start, cut.End),
            SpanPart.Dwell or SpanPart.ToolOff => (cut.End, cut.End),
            SpanPart.Finish => (cut.End, program.Finish!.Value),
            _ => (cut.Start, cut.Start),
        };
    }

    /// <summary>Where the machine is before a stroke.</summary>
    private CountsPoint Before(int stroke) => stroke == 0 ? program.Start : program.Strokes[stroke - 1].Sequences[^1].End;
}

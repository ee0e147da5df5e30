using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>The segments of one sequence that are still to be executed: 511 slots (galil-dmc.md B.7).</summary>
/// <param name="onePendingExit">True when a speed after "&gt;" is ignored while an earlier one has not been executed (B.4).</param>
/// <remarks>The executing segment still occupies its slot, so that free slots are 511 - (segments stored - _CS) at any time (F.1).</remarks>
internal sealed class SegmentBuffer(bool onePendingExit)
{
    public const int Slots = 511;
    private const double ShortestSegment = 1e-3;
    private const double LongestSequence = 2e9;

    private readonly Queue<VectorSegment> _segments = new(Slots);
    private readonly double[] _frameEnd = new double[Axis.Letters.Length];
    private VectorSegment? _pendingExit;

    public int FreeSlots => Slots - _segments.Count;

    public bool IsEmpty => _segments.Count == 0;

    public VectorSegment? Current => _segments.TryPeek(out var segment) ? segment : null;

    /// <summary>Path length of all segments stored for the sequence, executed ones included.</summary>
    public double Length { get; private set; }

    /// <summary>VE or LE has ended the sequence.</summary>
    public bool IsClosed { get; set; }

    /// <summary>The end of the last stored segment in the sequence frame; after a CR it is a real point (I, rounding rule).</summary>
    public ReadOnlySpan<double> FrameEnd => _frameEnd;

    public void Store(VectorSegment segment)
    {
        var refusal = segment.Length < ShortestSegment ? Tc.SegmentTooShort
            : _segments.Count >= Slots ? Tc.SegmentBufferFull
            : Length + segment.Length > LongestSequence ? Tc.SequenceTooLong
            : 0;
        if (refusal != 0) throw new CommandRefusedException(refusal);

        KeepOnePendingExit(segment);
        segment.StartLength = Length;
        Length += segment.Length;
        segment.PointAt(segment.Length, _frameEnd);
        _segments.Enqueue(segment);
    }

    public void Drop()
    {
        if (_segments.Dequeue() == _pendingExit) _pendingExit = null;
    }

    /// <summary>Removes the segments that have not been executed; length and end stay readable.</summary>
    public void Abandon()
    {
        _segments.Clear();
        _pendingExit = null;
    }

    public void Clear()
    {
        Abandon();
        Array.Clear(_frameEnd);
        Length = 0;
        IsClosed = false;
    }

    /// <summary>Removes the exit speed of a new segment while an earlier one is pending.</summary>
    private void KeepOnePendingExit(VectorSegment segment)
    {
        if (!onePendingExit || segment.ExitSpeed is null) return;
        if (_pendingExit is null) _pendingExit = segment;
        else segment.ExitSpeed = null;
    }
}

using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Follows a motion program in the order of cutting, as far as the controller has confirmed it.</summary>
internal sealed class ExecutedPath(MotionProgram program, JobMachine machine, JobLedger ledger, JobLog log)
{
    private readonly int _segments = program.SegmentCount;
    private int _stroke;
    private int _sequence;
    private int _segment;

    /// <summary>Segments confirmed so far.</summary>
    public int Count { get; private set; }

    /// <summary>Confirms every segment before <paramref name="count"/>, each once, and writes each sequence that is then complete to the journal.</summary>
    public void ConfirmUpTo(int count)
    {
        while (Count < Math.Min(count, _segments)) ConfirmNext();
    }

    private void ConfirmNext()
    {
        var stroke = program.Strokes[_stroke];
        var sequence = stroke.Sequences[_sequence];
        ledger.Confirm(sequence.Segments[_segment]);
        Count++;
        if (++_segment < sequence.Segments.Count) return;
        log.SequenceDone(machine);
        _segment = 0;
        if (++_sequence == stroke.Sequences.Count) (_stroke, _sequence) = (_stroke + 1, 0);
        if (_stroke < program.Strokes.Count) ledger.Enter(_stroke, _sequence);
    }
}

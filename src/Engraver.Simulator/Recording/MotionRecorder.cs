using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>Records the motion of the axes and the outputs: every sample of motion with its start position, spans of constant speed in closed form, and every
/// change of an output at rest.</summary>
internal sealed class MotionRecorder(MotionKernel motion, DigitalIo io, bool keepsRows)
{
    private MotionSample? _last;

    public MotionRecord Record { get; } = new(keepsRows);

    /// <summary>The last sample moved an axis.</summary>
    public bool IsMoving { get; private set; }

    /// <summary>The sample of the last row; 0 before the first.</summary>
    public long LastSample => _last?.Sample ?? 0;

    /// <summary>Called before a sample: records the start position of a motion, unless the last row already has it.</summary>
    public void Before(long sample)
    {
        if (IsMoving || !motion.CanProgress) return;
        var row = Row(sample - 1);
        if (_last is null || _last.Value with { Sample = row.Sample, Error = row.Error } != row) Append(row);
    }

    /// <summary>Called after a sample.</summary>
    public void After(long sample, bool moved)
    {
        IsMoving = moved;
        if (moved) Append(Row(sample));
    }

    /// <summary>Records the given number of samples after <paramref name="sample"/> at constant speed; the axes are at the end of the span.</summary>
    public void Passed(long sample, long samples, SteadyCourse[] courses)
    {
        _last = Row(sample + samples);
        Record.Append(new MotionSpan(sample, samples, _last.Value, courses));
    }

    /// <summary>Called after samples in which nothing happened.</summary>
    public void Rested() => IsMoving = false;

    /// <summary>Records an output change at rest; in motion the row of the sample contains it.</summary>
    public void OutputsChanged(long sample)
    {
        if (!IsMoving || !motion.CanProgress) Append(Row(sample));
    }

    private void Append(in MotionSample row)
    {
        _last = row;
        Record.Append(row);
    }

    private MotionSample Row(long sample)
    {
        var axes = motion.Axes;
        return new(sample, axes[0].Place, axes[1].Place, axes[2].Place, axes[3].Place, io.Outputs) { Error = (axes[0].Error, axes[1].Error, axes[2].Error, axes[3].Error) };
    }
}

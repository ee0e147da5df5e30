using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>Writes down what the axes and the outputs do: every sample of motion with the place it began from, and every change of an output at rest.</summary>
internal sealed class MotionRecorder(MotionKernel motion, DigitalIo io)
{
    private bool _wasMoving;

    public MotionRecord Record { get; } = new();

    /// <summary>Before a sample: the place that a motion starts from, unless the last row says it already.</summary>
    public void Before(long sample)
    {
        if (_wasMoving || !motion.CanProgress) return;
        var row = Row(sample - 1);
        var count = Record.Count;
        if (count == 0 || Record[count - 1] with { Sample = row.Sample } != row) Record.Append(row);
    }

    /// <summary>Behind a sample.</summary>
    public void After(long sample, bool moved)
    {
        _wasMoving = moved;
        if (moved) Record.Append(Row(sample));
    }

    /// <summary>Samples passed in which nothing could happen.</summary>
    public void Rested() => _wasMoving = false;

    /// <summary>In motion the row of the sample tells it.</summary>
    public void OutputsChanged(long sample)
    {
        if (!_wasMoving || !motion.CanProgress) Record.Append(Row(sample));
    }

    private MotionSample Row(long sample)
    {
        var axes = motion.Axes;
        return new(sample, axes[0].Reference, axes[1].Reference, axes[2].Reference, axes[3].Reference, io.Outputs);
    }
}

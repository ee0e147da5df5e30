using Engraver.Simulator;

namespace Engraver.App.Tests.RealWindow;

/// <summary>Measures the distance that the machine has moved with its tool on since this was created.</summary>
internal sealed class CutLength : IMotionListener, IDisposable
{
    private readonly byte _tool;
    private readonly IDisposable _subscription;
    private MotionSample? _last;
    private double _counts;

    /// <param name="tool">The output bits that are on during a cut.</param>
    public CutLength(RealMachine machine, byte tool)
    {
        _tool = tool;
        _subscription = machine.Controller.Record.Subscribe(this);
    }

    /// <summary>Length of the path in A and B, counts.</summary>
    public double Counts => Volatile.Read(ref _counts);

    public void Add(in MotionSample sample)
    {
        if (_last is { } last && (sample.Outputs & _tool) != 0) Volatile.Write(ref _counts, _counts + double.Hypot(sample.A - last.A, sample.B - last.B));
        _last = sample;
    }

    public void Add(MotionSpan span)
    {
        Add(span.First);
        Add(span.Last); // the chord of at most a quarter of an ellipse: accurate enough to find the middle of a job
    }

    public void Dispose() => _subscription.Dispose();
}

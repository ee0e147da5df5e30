using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Links;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Wires;

/// <summary>A simulated controller whose wires are recorded, and the operator of the job that runs on it.</summary>
/// <param name="baud">Of a serial line; 0 for a network.</param>
/// <param name="harm">What arrives instead of a line that is sent; null: the line itself.</param>
internal sealed class WireBench(int baud, int programLines = 1000, Func<string, string>? harm = null, params AxisSwitches[] switches) : IAsyncDisposable
{
    private readonly SimulatedBench _bench = new(programLines: programLines, serialNumber: 2143, switches: switches);

    public WireRecord Wire { get; } = new();

    public SimulatedController Controller => _bench.Controller;

    public JobControl Control { get; private set; } = new();

    public CancellationTokenSource Stop { get; } = new();

    /// <summary>The key that is held, in a jog or while the job is held.</summary>
    public JogControl Key { get; } = new(new JogVelocity(-600.0, 300.0));

    public Task<ControllerSession> OpenAsync() => ControllerSession.OpenAsync(
        _ => Task.FromResult(Wire.Over(new WithheldLink(baud == 0 ? new StreamLink(Controller.OpenConnection(), "memory") : _bench.OpenSerialLink(baud)) { Corrupt = harm })),
        new SessionOptions(), _bench.Clock, CancellationToken.None);

    /// <summary>Commands of another host, which are not recorded.</summary>
    public void Interfere(string command) => _bench.Interfere(command);

    /// <summary>A new control for the next job.</summary>
    public void TakeNewControl() => Control = new JobControl();

    public async ValueTask DisposeAsync()
    {
        Stop.Dispose();
        await _bench.DisposeAsync();
    }
}

/// <summary>Something that the operator does, or that happens to the machine.</summary>
/// <param name="At">Controller seconds since the job began; it happens at the first report from there on.</param>
internal sealed record WireStep(double At, Action<WireBench> Happens);

/// <summary>Lets the steps of a case happen on the thread of the job, when it reports.</summary>
internal sealed class WireOperator(WireBench bench, params IReadOnlyList<WireStep> steps) : IProgress<JobProgress>
{
    private int _next;

    public void Report(JobProgress value)
    {
        while (_next < steps.Count && value.Seconds >= steps[_next].At) steps[_next++].Happens(bench);
    }
}

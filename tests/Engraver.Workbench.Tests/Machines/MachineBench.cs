using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>A machine session connected over TCP to a simulated controller controlled by the test; the session's clock is advanced only by the test.</summary>
internal sealed class MachineBench : IAsyncDisposable
{
    private static readonly TimeSpan s_untilNextStep = TimeSpan.FromSeconds(1); // Wall-clock time.
    private static readonly TimeSpan s_step = TimeSpan.FromMilliseconds(100);
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));

    /// <summary>A drawing whose zero is at the controller's zero.</summary>
    public static PlacementResult Placed { get; } = new(default(CountsPoint), OriginSource.Work, null);

    private MachineBench(SimulatorOptions options)
    {
        Controller = new SimulatedController(options);
        Machine = new MachineSession(Time);
    }

    public ManualTimeProvider Time { get; } = new();

    public SimulatedController Controller { get; }

    public MachineSession Machine { get; }

    public CancellationToken Limit => _limit.Token;

    public string? Address { get; private set; }

    public static async Task<MachineBench> ConnectedAsync(SimulatorOptions? options = null)
    {
        var bench = new MachineBench(options ?? new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await bench.Controller.ListenTcpAsync(0, bench.Limit);
        var clock = await bench.Controller.ListenClockAsync(bench.Limit);
        bench.Address = FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}");
        await bench.Machine.Connection.ConnectAsync(ControllerAddress.Parse(FormattableString.Invariant($"{bench.Address}?clock={clock.Port}")), bench.Limit);
        return bench;
    }

    /// <summary>A line of 20 mm and a circle.</summary>
    public static PreparedJob Job(MachineProfile? profile = null) => JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 20, 0).Circle(40, 0, 5).Build(), new DrawingSettings { Machine = profile ?? MachineProfile.Default }, MotionStyle.Continuous);

    /// <summary>Advances the clock poll by poll until the status satisfies the condition.</summary>
    public async Task<MachineStatus> UntilAsync(Func<MachineStatus, bool> wanted)
    {
        while (true)
        {
            var changed = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
            void OnChanged(object? sender, EventArgs e) => changed.TrySetResult();
            Machine.Changed += OnChanged;
            var status = Machine.Status;
            if (wanted(status)) return status;
            await PassAsync(changed.Task);
            Machine.Changed -= OnChanged;
        }
    }

    /// <summary>Advances the clock until something changes: a step waits until the next poll is scheduled, if there is one.</summary>
    private async Task PassAsync(Task changed)
    {
        while (true)
        {
            await ComesSoonAsync(Task.WhenAny(Time.FallsDueAsync(s_step), changed));
            Time.Advance(s_step);
            if (await ComesSoonAsync(changed)) return;
        }
    }

    private async Task<bool> ComesSoonAsync(Task awaited)
    {
        try
        {
            await awaited.WaitAsync(s_untilNextStep, Limit);
            return true;
        }
        catch (TimeoutException)
        {
            return false;
        }
    }

    public async ValueTask DisposeAsync()
    {
        await Machine.DisposeAsync();
        await Controller.DisposeAsync();
        _limit.Dispose();
    }
}

using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The machine of a real window: a separate simulated controller behind TCP, with home switches. The test controls its clock, which is stopped
/// during the operator's input, so that a job is always in its middle, however slow this computer is.</summary>
internal sealed class RealMachine : IAsyncDisposable
{
    /// <summary>Counts per millimetre, both axes.</summary>
    public const int Scale = 1000;

    /// <summary>Distance of the axes from their home switches at power-on.</summary>
    private const int FromHome = 25 * Scale;

    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(5);
    private static readonly TimeSpan s_step = TimeSpan.FromMilliseconds(20);

    /// <summary>Steps at rest are longer: an axis at rest shows no motion during the operator's input, but the host still polls it, and a long pause would
    /// take thousands of polls.</summary>
    private static readonly TimeSpan s_stepAtRest = TimeSpan.FromMilliseconds(4);

    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(60); // only a failing test waits that long

    private readonly ManualTimeProvider _clock = new();
    private readonly Timer _timer;
    private readonly Lock _gate = new();
    private Func<ControllerStatus, bool>? _until;
    private TaskCompletionSource<ControllerStatus>? _met;
    private bool _isRunning;

    private RealMachine()
    {
        Controller = new SimulatedController(new SimulatorOptions
        {
            Speed = 10,
            SerialNumber = 4711,
            Time = _clock,
            Switches = [new AxisSwitches(0) { HomeAt = -FromHome, IsHomeBelow = true }, new AxisSwitches(1) { HomeAt = -FromHome, IsHomeBelow = true }],
        });
        _timer = new Timer(_ => Advance(), null, s_interval, s_interval);
    }

    public SimulatedController Controller { get; }

    /// <summary>Last recorded position of the axes, counts of the controller.</summary>
    public (int A, int B) Place => Controller.Record is { Count: > 0 and var count } record && record[count - 1] is var row ? (row.A, row.B) : default;

    public string Address { get; private set; } = "";

    public static async Task<RealMachine> SwitchedOnAsync()
    {
        var machine = new RealMachine();
        var place = await machine.Controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await machine.Controller.ListenClockAsync(CancellationToken.None);
        machine.Address = FormattableString.Invariant($"tcp://127.0.0.1:{place.Port}?clock={clock.Port}");
        return machine;
    }

    /// <summary>The profile of this machine as a file: home switches below, a travel of 400 by 300 mm.</summary>
    public static string ProfileIn(string folder)
    {
        var file = Path.Combine(folder, "plate-engraver.json");
        File.WriteAllText(file, """
            {
              "travelX": { "min": 0, "max": 400 }, "travelY": { "min": 0, "max": 300 }, "parkX": 5, "parkY": 290,
              "homing": [ { "axis": "Y", "by": "switch", "direction": "minus" }, { "axis": "X", "by": "switch", "direction": "minus" } ],
              "inputs": { "1": "door" }, "outputs": { "1": "engraver", "2": "vacuum" }
            }
            """);
        return file;
    }

    /// <summary>Starts the clock.</summary>
    public void StartClock()
    {
        lock (_gate) _isRunning = true;
    }

    /// <summary>Runs the clock until the controller meets a condition, then stops it.</summary>
    /// <exception cref="TimeoutException">The condition was not met; the clock is stopped.</exception>
    public async Task<ControllerStatus> RunUntilAsync(Func<ControllerStatus, bool> condition, TimeSpan? patience = null)
    {
        var met = new TaskCompletionSource<ControllerStatus>(TaskCreationOptions.RunContinuationsAsynchronously);
        lock (_gate) (_until, _met, _isRunning) = (condition, met, true);
        try
        {
            return await met.Task.WaitAsync(patience ?? s_timeout);
        }
        catch (TimeoutException)
        {
            lock (_gate) (_until, _met, _isRunning) = (null, null, false);
            throw;
        }
    }

    /// <summary>Advances the clock immediately, while no host is connected.</summary>
    public void Advance(TimeSpan controllerTime)
    {
        lock (_gate) _clock.Advance(controllerTime / 10);
    }

    public async ValueTask DisposeAsync()
    {
        await _timer.DisposeAsync();
        await Controller.DisposeAsync();
    }

    private void Advance()
    {
        if (!_gate.TryEnter()) return; // the previous step is not complete yet
        try
        {
            if (_until is { } until && until(Controller.Status))
            {
                _isRunning = false;
                _met!.TrySetResult(Controller.Status);
                (_until, _met) = (null, null);
            }

            if (_isRunning) _clock.Advance(Controller.Status.IsMoving ? s_step : s_stepAtRest);
        }
        finally
        {
            _gate.Exit();
        }
    }
}

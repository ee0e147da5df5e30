using System.Globalization;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>A simulated machine with limit switches at -1 mm in X and Y, switched on at 20, 15, and profiles with which it is homed.</summary>
internal sealed class HomedSimulator : IAsyncDisposable
{
    private const int CountsPerMillimetre = 1000;

    /// <param name="serialNumber">Identifies the machine to the verbs.</param>
    public HomedSimulator(int serialNumber) => Controller = new SimulatedController(new SimulatorOptions
    {
        Speed = double.PositiveInfinity,
        SerialNumber = serialNumber,
        Switches =
        [
            new AxisSwitches(0) { ReverseLimitAt = -21 * CountsPerMillimetre, ForwardLimitAt = 480 * CountsPerMillimetre },
            new AxisSwitches(1) { ReverseLimitAt = -16 * CountsPerMillimetre, ForwardLimitAt = 480 * CountsPerMillimetre },
        ],
    });

    public SimulatedController Controller { get; }

    /// <summary>A profile of the machine; its homing has no position of the mark, so that it is independent of the scale.</summary>
    public static string Profile(double countsPerMillimetre = CountsPerMillimetre, string more = "") => string.Create(CultureInfo.InvariantCulture, $$"""
        {
          "countsPerMillimetreX": {{countsPerMillimetre}}, "countsPerMillimetreY": {{countsPerMillimetre}}, {{more}}
          "travelX": { "min": 0, "max": 300 }, "travelY": { "min": 0, "max": 200 },
          "homing": [
            { "axis": "X", "by": "limit", "direction": "minus", "zero": 0, "backOff": 1, "fastMmPerMinute": 480 },
            { "axis": "Y", "by": "limit", "direction": "minus", "zero": 0, "backOff": 1 }
          ]
        }
        """);

    public async Task<string> AddressAsync(CancellationToken limit)
    {
        var port = (await Controller.ListenTcpAsync(0, limit)).Port;
        var clock = (await Controller.ListenClockAsync(limit)).Port; // A busy computer must not count as a silent host.
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
    }

    /// <summary>Counts in a millisecond of the fastest sample from a row of the record on, of A or B.</summary>
    public int MaxStepFrom(int row)
    {
        var rows = Controller.Record.Snapshot().Skip(row).ToList();
        return rows.Zip(rows.Skip(1)).Where(pair => pair.Second.Sample == pair.First.Sample + 1).Max(pair => Math.Max(Math.Abs(pair.Second.A - pair.First.A), Math.Abs(pair.Second.B - pair.First.B)));
    }

    public ValueTask DisposeAsync() => Controller.DisposeAsync();
}

using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using Engraver.Cli.Options;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver simulate</c>: serves a simulated DMC-2143 on loopback and on a pseudo-terminal until Ctrl-C.</summary>
internal static class SimulateVerb
{
    private const string Blank = "blank";
    private const string Column = "column";

    public static Command Build(VerbHost host)
    {
        var port = new Option<int?>("--tcp") { HelpName = "PORT", Description = Wording.Get("Simulate.Tcp"), CustomParser = ParsePort };
        var datagrams = new Option<int?>("--udp") { HelpName = "PORT", Description = Wording.Get("Simulate.Udp"), CustomParser = ParsePort };
        var serial = new Option<string?>("--serial") { HelpName = "PATH", Description = Wording.Get("Simulate.SerialPort") };
        var baud = new Option<int>("--baud") { HelpName = "N", Description = Wording.Get("Simulate.Baud"), DefaultValueFactory = _ => ControllerAddress.DefaultBaud, CustomParser = ParseBaud };
        var speed = new Option<double>("--speed") { HelpName = "1|N|max", Description = Wording.Get("Simulate.Speed"), DefaultValueFactory = _ => 1.0, CustomParser = ParseSpeed };
        var record = new Option<string?>("--record") { HelpName = "FILE", Description = Wording.Get("Simulate.Record") };
        var machine = new Option<string?>("--machine") { HelpName = "PROFILE.json", Description = Wording.Get("Simulate.Machine") };
        var faults = new Option<string?>("--faults") { HelpName = "FILE", Description = Wording.Get("Simulate.FaultsFile") };
        var numbers = new Option<string>("--numbers") { HelpName = "blank|column", Description = Wording.Get("Simulate.Numbers"), DefaultValueFactory = _ => Blank, CustomParser = ParseSpacing };
        var number = new Option<int?>("--serial-number") { HelpName = "N", Description = Wording.Get("Simulate.SerialNumber") };
        var decode = new Option<double>("--decode") { HelpName = "SECONDS", Description = Wording.Get("Simulate.Decode"), CustomParser = OptionValue.SecondsFromZero };
        var earlyRamps = new Option<bool>("--early-ramps") { Description = Wording.Get("Simulate.EarlyRamps") };
        var onePendingExit = new Option<bool>("--one-pending-exit") { Description = Wording.Get("Simulate.OnePendingExit") };
        var ownEntrySpeed = new Option<bool>("--own-entry-speed") { Description = Wording.Get("Simulate.OwnEntrySpeed") };
        var command = new MachineCommand("simulate", Wording.Get("Simulate.Summary"))
        {
            port, datagrams, serial, baud, speed, record, machine, faults, numbers, number, decode, earlyRamps, onePendingExit, ownEntrySpeed,
        };
        command.Validators.Add(result =>
        {
            if (result.GetResult(baud) is { Implicit: false } && result.GetResult(serial) is null) result.AddError(Wording.Get("Simulate.BaudNeedsSerial"));
        });
        command.SetAction(async (parsed, stop) =>
        {
            var plan = parsed.GetValue(faults) is { } file ? ReadFaults(file) : null;
            if (plan is not null && FaultFile.Findings(plan) is { Count: > 0 } findings)
            {
                host.Report(parsed, parsed.GetValue(faults)!, findings);
                return ExitCode.Usage;
            }

            var served = ServedSimulator.Create(new ServedSimulatorSettings(parsed.GetValue(speed))
            {
                Profile = parsed.GetValue(machine) is { } path ? ProfileOption.Load(parsed, path) : null,
                Faults = plan,
                SignColumn = parsed.GetValue(numbers) == Column,
                SerialNumber = parsed.GetValue(number),
                EarlyRamps = parsed.GetValue(earlyRamps),
                OnePendingExit = parsed.GetValue(onePendingExit),
                OwnEntrySpeed = parsed.GetValue(ownEntrySpeed),
                DecodeTime = TimeSpan.FromSeconds(parsed.GetValue(decode)),
            });
            return await RunAsync(host, parsed.GetValue(port), parsed.GetValue(datagrams), parsed.GetValue(serial), parsed.GetValue(baud), parsed.GetValue(record), served, stop).ConfigureAwait(false);
        });
        return command;
    }

    private static async Task<int> RunAsync(VerbHost host, int? port, int? datagrams, string? serial, int baud, string? record, ServedSimulator served, CancellationToken stop)
    {
        await using (served)
        {
            if (record is not null) served.RecordTo(Create(record));
            try
            {
                if (served.Speed != 1.0) await OfferClockAsync(host, served, stop).ConfigureAwait(false);
                await ServeAsync(host, served, port, datagrams, serial, baud, stop).ConfigureAwait(false);
            }
            catch (OperationCanceledException) when (stop.IsCancellationRequested)
            {
                // A signal may arrive before all lines are written; it ends the serving like any other.
            }
        }

        return served.RecordFailure is { } failure ? throw new UsageException(Wording.Get("Simulate.Incomplete", record, failure.Message), failure) : ExitCode.Done;
    }

    /// <summary>At a speed other than real time the controller offers its clock to hosts that synchronise with it (docs/simulator-fidelity.md, "The
    /// clock").</summary>
    private static async Task OfferClockAsync(VerbHost host, ServedSimulator controller, CancellationToken stop)
    {
        var place = await controller.ListenClockAsync(stop).ConfigureAwait(false);
        await WriteAsync(host, string.Create(CultureInfo.InvariantCulture, $"clock 127.0.0.1:{place.Port}"), stop).ConfigureAwait(false);
    }

    /// <summary>Listens on every requested transport, reports it, and serves until the signal.</summary>
    /// <exception cref="OperationCanceledException">The signal.</exception>
    /// <exception cref="InvalidOperationException">Internal error of the simulator; its clients are disconnected.</exception>
    private static async Task ServeAsync(VerbHost host, ServedSimulator controller, int? port, int? datagrams, string? serial, int baud, CancellationToken stop)
    {
        if (port is not null || (serial is null && datagrams is null)) await ListenAsync(host, "tcp", controller.ListenTcpAsync, port ?? 0, stop).ConfigureAwait(false);
        if (datagrams is { } place) await ListenAsync(host, "udp", controller.ListenUdpAsync, place, stop).ConfigureAwait(false);

        if (serial is not null)
        {
            await ServeSerialAsync(controller, serial, baud, stop).ConfigureAwait(false);
            await WriteAsync(host, $"listening serial://{serial}", stop).ConfigureAwait(false);
        }

        await controller.Failure.WaitAsync(stop).ConfigureAwait(false);
    }

    /// <exception cref="ControllerLinkException">The port is taken or may not be used.</exception>
    private static async Task ListenAsync(VerbHost host, string transport, Func<int, CancellationToken, Task<IPEndPoint>> listen, int port, CancellationToken stop)
    {
        try
        {
            var place = await listen(port, stop).ConfigureAwait(false);
            await WriteAsync(host, string.Create(CultureInfo.InvariantCulture, $"listening {transport}://127.0.0.1:{place.Port}"), stop).ConfigureAwait(false);
        }
        catch (IOException taken)
        {
            throw new ControllerLinkException(Wording.Get("Simulate.PortUnavailable", port.ToString(CultureInfo.InvariantCulture), SystemErrorText.FromException(taken), transport), taken);
        }
    }

    private static async Task WriteAsync(VerbHost host, string line, CancellationToken stop)
    {
        await host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        await host.Out.FlushAsync(stop).ConfigureAwait(false);
    }

    /// <exception cref="UsageException">The path cannot become a serial port.</exception>
    private static async Task ServeSerialAsync(ServedSimulator controller, string path, int baud, CancellationToken stop)
    {
        try
        {
            await controller.ServeSerialAsync(path, baud, null, stop).ConfigureAwait(false);
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or PlatformNotSupportedException)
        {
            throw new UsageException(Wording.Get("Simulate.Serial", path, SystemErrorText.FromException(unusable)), unusable);
        }
    }

    /// <exception cref="UsageException">The file cannot be written.</exception>
    private static StreamWriter Create(string path)
    {
        try
        {
            return new StreamWriter(path);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Verbs.CannotWrite", path, SystemErrorText.FromException(unwritable)), unwritable);
        }
    }

    /// <exception cref="UsageException">The file cannot be read.</exception>
    private static string ReadFaults(string path)
    {
        try
        {
            return File.ReadAllText(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Simulate.Faults", path, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }

    private static int? ParsePort(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port <= 65535) return port;
        result.AddError(Wording.Get("Simulate.InvalidPort", ((OptionResult)result.Parent!).Option.Name, word));
        return null;
    }

    private static int ParseBaud(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var baud) && SerialLine.Rates.Contains(baud)) return baud;
        result.AddError(Wording.Get("Simulate.InvalidBaud", word, string.Join(", ", SerialLine.Rates)));
        return ControllerAddress.DefaultBaud;
    }

    private static string ParseSpacing(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word is not (Blank or Column)) result.AddError(Wording.Get("Simulate.InvalidNumbers", word));
        return word;
    }

    private static double ParseSpeed(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word == "max") return double.PositiveInfinity;
        if (double.TryParse(word, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var speed) && speed > 0.0 && double.IsFinite(speed)) return speed;
        result.AddError(Wording.Get("Simulate.InvalidSpeed", word));
        return 1.0;
    }
}

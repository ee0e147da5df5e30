using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Engraver.Galil.Protocol;
using Engraver.Simulator;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver simulate</c>: serves a simulated DMC-2143 on loopback until Ctrl-C.</summary>
internal static class SimulateVerb
{
    public static Command Build(VerbHost host)
    {
        var port = new Option<int>("--tcp") { HelpName = "PORT", Description = "Port on loopback; 0 lets the system pick (also the default).", CustomParser = ParsePort };
        var speed = new Option<double>("--speed") { HelpName = "1|N|max", Description = "Controller seconds for each second on the wall; max: virtual time.", DefaultValueFactory = _ => 1.0, CustomParser = ParseSpeed };
        var record = new Option<string?>("--record") { HelpName = "FILE", Description = "Write every motor sample and output change as CSV (t,a,b,c,d,outputs)." };
        var command = new Command("simulate", "Serves a simulated DMC-2143 controller until Ctrl-C.") { port, speed, record };
        command.SetAction((parsed, stop) => RunAsync(host, parsed.GetValue(port), parsed.GetValue(speed), parsed.GetValue(record), stop));
        return command;
    }

    private static async Task<int> RunAsync(VerbHost host, int port, double speed, string? record, CancellationToken stop)
    {
        using var csv = record is null ? null : Create(record);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = speed });
        if (csv is not null) controller.Record.AttachCsv(csv);
        var place = await ListenAsync(controller, port, stop).ConfigureAwait(false);
        await host.Out.WriteLineAsync(string.Create(CultureInfo.InvariantCulture, $"listening tcp://127.0.0.1:{place.Port}")).ConfigureAwait(false);
        await host.Out.FlushAsync(stop).ConfigureAwait(false);

        var ended = new TaskCompletionSource();
        await using var registration = stop.Register(ended.SetResult).ConfigureAwait(false);
        await ended.Task.ConfigureAwait(false);
        return ExitCode.Done;
    }

    /// <exception cref="ControllerLinkException">The port is taken or may not be used.</exception>
    private static async Task<IPEndPoint> ListenAsync(SimulatedController controller, int port, CancellationToken stop)
    {
        try
        {
            return await controller.ListenTcpAsync(port, stop).ConfigureAwait(false);
        }
        catch (SocketException taken)
        {
            throw new ControllerLinkException($"Port {port.ToString(CultureInfo.InvariantCulture)} cannot be served: {taken.Message}. Use --tcp 0 to let the system pick one.", taken);
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
            throw new UsageException($"{path} cannot be written: {unwritable.Message}", unwritable);
        }
    }

    private static int ParsePort(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port <= 65535) return port;
        result.AddError($"--tcp: '{word}' is not a port (0 to 65535).");
        return 0;
    }

    private static double ParseSpeed(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word == "max") return double.PositiveInfinity;
        if (double.TryParse(word, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var speed) && speed > 0.0) return speed;
        result.AddError($"--speed: '{word}' is neither a number above 0 nor max.");
        return 1.0;
    }
}

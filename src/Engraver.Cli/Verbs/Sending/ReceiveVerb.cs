using System.CommandLine;
using System.Globalization;
using System.Text;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Diagnostics;
using Engraver.Core.Sending;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Sending;

namespace Engraver.Cli.Verbs.Sending;

/// <summary><c>engraver receive</c>: takes a program from a serial line into a file, and says where its parity was wrong.</summary>
internal sealed class ReceiveVerb(VerbHost host)
{
    private readonly Option<SendAddress?> _from = LineOption.New("--from", Wording.Get("Receive.From"));
    private readonly Option<string> _output = new("-o", "--output") { Required = true, HelpName = "OUT", Description = Wording.Get("Receive.Output") };
    private readonly Option<double> _silence = new("--silence") { HelpName = "SECONDS", Description = Wording.Get("Receive.Silence"), CustomParser = OptionValue.SecondsOfADay, DefaultValueFactory = _ => 5.0 };
    private readonly Option<bool> _json = JsonOption.New();

    public static Command Build(VerbHost host)
    {
        var verb = new ReceiveVerb(host);
        var command = new MachineCommand("receive", Wording.Get("Receive.Receive")) { verb._from, verb._output, verb._silence, verb._json };
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var (address, path) = (parsed.GetRequiredValue(_from)!, parsed.GetRequiredValue(_output));
        VerbHost.CheckPlace(path);
        var receiver = new ProgramReceiver(address.Frame);
        var reason = await ListenAsync(receiver, address, TimeSpan.FromSeconds(parsed.GetValue(_silence)), host.Quiet(parsed), stop).ConfigureAwait(false);
        var (characters, lines) = (receiver.Characters.ToArray(), SendText.Lines(receiver.Characters.ToArray()));
        IReadOnlyList<Diagnostic> findings = receiver.Damaged == 0 ? [] : [SendingRules.ParityWrong.At(new SourceRef(receiver.FirstDamagedLine), Text(receiver.Damaged), Text(receiver.FirstDamagedLine), address.Frame.Name())];
        if (characters.Length > 0) host.Write(path, writer => writer.Write(string.Concat(lines.Select(line => Encoding.Latin1.GetString(line.Span) + "\n"))));
        if (parsed.GetValue(_json)) ContractJson.Write(host.Out, new ReceiveJson(path, lines.Count, characters.Length, receiver.Damaged, [.. findings.Select(DiagnosticJson.From)]), SendContract.Default.ReceiveJson);
        else await host.Out.WriteLineAsync(Wording.Get("Receive.Received", lines.Count, characters.Length)).ConfigureAwait(false);
        var code = host.Report(parsed, path, findings);
        if (reason is not null) await host.Error.WriteLineAsync($"engraver: {reason}").ConfigureAwait(false);
        return (reason, characters.Length) switch { (not null, _) => ExitCode.LinkLost, (_, 0) => stop.IsCancellationRequested ? ExitCode.StoppedByOperator : ExitCode.LinkLost, _ => code };
    }

    /// <returns>Why the line ended; null when the sender was silent or the operator had enough.</returns>
    private async Task<string?> ListenAsync(ProgramReceiver receiver, SendAddress address, TimeSpan silence, bool quiet, CancellationToken stop)
    {
        try
        {
            await using var line = ProgramLine.Open(address, silence, TimeProvider.System);
            if (!quiet) await host.Error.WriteLineAsync(Wording.Get("Receive.Listening", address)).ConfigureAwait(false);
            await receiver.ListenAsync(line, silence, progress: null, TimeProvider.System, stop).ConfigureAwait(false);
            return null;
        }
        catch (IOException gone)
        {
            return gone.Message;
        }
        catch (PlatformNotSupportedException unbuilt)
        {
            throw new UsageException(unbuilt.Message, unbuilt);
        }
    }

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);
}

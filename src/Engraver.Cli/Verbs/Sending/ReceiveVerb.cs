using System.CommandLine;
using System.Text;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Sending;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Sending;

namespace Engraver.Cli.Verbs.Sending;

/// <summary><c>engraver receive</c>: receives a program from a serial line into a file, and reports parity errors.</summary>
internal sealed class ReceiveVerb(VerbHost host)
{
    /// <summary>Suffix of the file name of a program that may be incomplete, so that it is not taken for a complete one.</summary>
    private const string IncompleteSuffix = ".part";

    private readonly Option<SendAddress?> _from = LineOption.New("--from", Wording.Get("Receive.From"));
    private readonly Option<string> _output = new("-o", "--output") { Required = true, HelpName = "OUT", Description = Wording.Get("Receive.Output") };
    private readonly Option<double> _silence = new("--silence") { HelpName = "SECONDS", Description = Wording.Get("Receive.Silence"), CustomParser = OptionValue.SecondsOfADay, DefaultValueFactory = _ => 5.0 };
    private readonly Option<bool> _json = JsonOption.New();

    public static Command Build(VerbHost host)
    {
        var verb = new ReceiveVerb(host);
        var command = new MachineCommand("receive", Wording.Get("Receive.Summary")) { verb._from, verb._output, verb._silence, verb._json };
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var (address, path) = (parsed.GetRequiredValue(_from)!, parsed.GetRequiredValue(_output));
        VerbHost.CheckWritable(path);
        var receiver = new ProgramReceiver(address.Frame);
        var (end, reason) = await ListenAsync(receiver, address, TimeSpan.FromSeconds(parsed.GetValue(_silence)), parsed, stop).ConfigureAwait(false);
        var characters = receiver.Characters.ToArray();
        var lines = SendText.Lines(characters);
        var file = characters.Length == 0 ? null : end == ReceiveEnd.Complete ? path : path + IncompleteSuffix;
        IReadOnlyList<Diagnostic> findings = receiver.Damaged == 0 ? [] : [SendingRules.ParityWrong.At(new SourceRef(receiver.FirstDamagedLine), NumberText.Whole(receiver.Damaged), NumberText.Whole(receiver.FirstDamagedLine), address.Frame.Name())];
        if (file is not null) host.Write(file, writer => writer.Write(string.Concat(lines.Select(line => Encoding.Latin1.GetString(line.Span) + "\n"))));
        if (parsed.GetValue(_json)) ContractJson.Write(host.Out, new ReceiveJson(Word(end), file, lines.Count, characters.Length, receiver.Damaged, [.. findings.Select(DiagnosticJson.From)]), SendContract.Default.ReceiveJson);
        else await host.Out.WriteLineAsync(Wording.Get("Receive.Received", lines.Count, characters.Length)).ConfigureAwait(false);
        var code = host.Report(parsed, path, findings);
        if (reason is not null) await host.Error.WriteLineAsync($"engraver: {reason}").ConfigureAwait(false);
        if (file is not null && end != ReceiveEnd.Complete) await host.Error.WriteLineAsync(Wording.Get("Receive.Incomplete", file)).ConfigureAwait(false);
        return end switch { ReceiveEnd.Complete => code, ReceiveEnd.Stopped => ExitCode.StoppedByOperator, _ => ExitCode.LinkLost };
    }

    /// <returns>The outcome, and a sentence with the reason if the line or the other side caused it.</returns>
    private async Task<(ReceiveEnd End, string? Reason)> ListenAsync(ProgramReceiver receiver, SendAddress address, TimeSpan silence, ParseResult parsed, CancellationToken stop)
    {
        try
        {
            await using var line = SerialProgramPort.Open(address, silence, TimeProvider.System);
            if (!host.Quiet(parsed)) await host.Error.WriteLineAsync(Wording.Get("Receive.Listening", address)).ConfigureAwait(false);
            var isWhole = await receiver.ListenAsync(line, silence, host.Verbose(parsed) ? new LineCount(host.Error) : null, TimeProvider.System, stop).ConfigureAwait(false);
            if (!isWhole) return (ReceiveEnd.Stopped, null);
            return receiver.Characters.Count > 0 ? (ReceiveEnd.Complete, null) : (ReceiveEnd.Silent, Wording.Get("Receive.NothingReceived", silence.TotalSeconds));
        }
        catch (IOException gone)
        {
            return (ReceiveEnd.LinkLost, SystemErrorText.FromException(gone));
        }
        catch (PlatformNotSupportedException unbuilt)
        {
            throw new UsageException(unbuilt.Message, unbuilt);
        }
    }

    private static string Word(ReceiveEnd end) => end switch { ReceiveEnd.Complete => "complete", ReceiveEnd.Stopped => "stopped", ReceiveEnd.Silent => "silent", _ => "linkLost" };

    /// <summary>Shows each received line.</summary>
    private sealed class LineCount(TextWriter error) : IProgress<int>
    {
        private int _lines;

        public void Report(int value)
        {
            if (value <= _lines) return;
            _lines = value;
            error.WriteLine(Wording.Get("Receive.Lines", value));
        }
    }

    private enum ReceiveEnd : byte
    {
        /// <summary>Data was received, then the line was silent.</summary>
        Complete,

        /// <summary>Stopped by the operator.</summary>
        Stopped,

        /// <summary>Nothing was received.</summary>
        Silent,

        LinkLost,
    }
}

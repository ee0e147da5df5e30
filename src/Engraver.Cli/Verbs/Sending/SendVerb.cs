using System.CommandLine;
using Engraver.Cli.Output;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Sending;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Sending;

namespace Engraver.Cli.Verbs.Sending;

/// <summary><c>engraver send</c>: sends a program file as plain text over a serial line to a machine control.</summary>
internal sealed class SendVerb
{
    private readonly VerbHost _host;
    private readonly Argument<string> _file = new("FILE") { Description = Wording.Get("Send.File") };
    private readonly Option<SendAddress?> _to = LineOption.New("--to", Wording.Get("Send.To"));
    private readonly Option<string> _lineEnd = new("--line-end") { Description = Wording.Get("Send.LineEnd"), DefaultValueFactory = _ => "crlf" };
    private readonly Option<int> _leader = Count("--leader", Wording.Get("Send.Leader"), SendFormat.MaxNuls);
    private readonly Option<int> _trailer = Count("--trailer", Wording.Get("Send.Trailer"), SendFormat.MaxNuls);
    private readonly Option<string> _start = Text("--start-text", Wording.Get("Send.Start"));
    private readonly Option<string> _end = Text("--end-text", Wording.Get("Send.End"));
    private readonly Option<int> _characterDelay = Count("--character-delay", Wording.Get("Send.CharacterDelay"), MaxDelay);
    private readonly Option<int> _lineDelay = Count("--line-delay", Wording.Get("Send.LineDelay"), MaxDelay);
    private readonly Option<int> _maxPause = Count("--hold-timeout", Wording.Get("Send.HoldTimeout"), 86_400, 60);
    private readonly Option<int?> _program = new("--program") { HelpName = "N", Description = Wording.Get("Send.Program") };
    private readonly Option<bool> _json = JsonOption.New();

    /// <summary>Milliseconds.</summary>
    private const int MaxDelay = 60_000;

    private SendVerb(VerbHost host)
    {
        _host = host;
        _lineEnd.AcceptOnlyFromAmong("cr", "lf", "crlf");
    }

    public static Command Build(VerbHost host)
    {
        var verb = new SendVerb(host);
        var command = new MachineCommand("send", Wording.Get("Send.Summary")) { verb._file, verb._to, verb._lineEnd, verb._leader, verb._trailer, verb._start, verb._end, verb._characterDelay, verb._lineDelay, verb._maxPause, verb._program, verb._json };
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var (address, path, format) = (parsed.GetRequiredValue(_to)!, parsed.GetRequiredValue(_file), Format(parsed));
        if (!format.Fits(address.Frame)) throw new UsageException(Wording.Get("Send.TextNotEncodable", address.Frame.Name()));
        var encoded = Read(path).Encode(parsed.GetValue(_program), format, address.Frame);
        if (encoded.Job is not { } job) return _host.Report(parsed, path, [encoded.Refusal!]);
        var pace = new SendPace(address.Frame, address.CharacterTime)
        {
            CharacterDelay = TimeSpan.FromMilliseconds(parsed.GetValue(_characterDelay)), LineDelay = TimeSpan.FromMilliseconds(parsed.GetValue(_lineDelay)),
            ObeysXoff = address.Flow == SerialFlow.XonXoff, MaxPause = TimeSpan.FromSeconds(parsed.GetValue(_maxPause)),
        };
        var result = await SendAsync(address, job, pace, parsed.GetValue(_json) || _host.Quiet(parsed), stop).ConfigureAwait(false);
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, SendJson.From(result), SendContract.Default.SendJson);
        if (result.Outcome == SendOutcome.Complete && !parsed.GetValue(_json)) await _host.Out.WriteLineAsync(SendWording.Of(result)).ConfigureAwait(false);
        if (result.Outcome != SendOutcome.Complete) await _host.Error.WriteLineAsync($"engraver: {SendWording.Of(result)}").ConfigureAwait(false);
        return result.Outcome switch { SendOutcome.Complete => ExitCode.Done, SendOutcome.Stopped => ExitCode.StoppedByOperator, _ => ExitCode.LinkLost };
    }

    private static async Task<SendResult> SendAsync(SendAddress address, SendJob job, SendPace pace, bool silent, CancellationToken stop)
    {
        try
        {
            await using var line = SerialProgramPort.Open(address, pace.MaxPause, TimeProvider.System);
            return await ProgressBar.OfSendingAsync(silent, job.Lines.Count, progress => ProgramSender.SendAsync(line, job, pace, progress, TimeProvider.System, stop)).ConfigureAwait(false);
        }
        catch (PlatformNotSupportedException unbuilt)
        {
            throw new UsageException(unbuilt.Message, unbuilt);
        }
    }

    private SendFormat Format(ParseResult parsed) => new()
    {
        LineEnd = parsed.GetValue(_lineEnd) switch { "cr" => "\r", "lf" => "\n", _ => "\r\n" },
        LeaderNuls = parsed.GetValue(_leader),
        TrailerNuls = parsed.GetValue(_trailer),
        Start = SendFormat.Unescape(parsed.GetValue(_start) ?? "")!,
        End = SendFormat.Unescape(parsed.GetValue(_end) ?? "")!,
    };

    /// <exception cref="UsageException">The file cannot be read.</exception>
    private static SendFile Read(string path)
    {
        try
        {
            return SendFile.Read(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Send.CannotRead", path, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }

    private static Option<int> Count(string name, string description, int max, int standard = 0)
    {
        var option = new Option<int>(name) { HelpName = "N", Description = description, DefaultValueFactory = _ => standard };
        option.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: var word }] && !(int.TryParse(word, System.Globalization.CultureInfo.InvariantCulture, out var value) && value >= 0 && value <= max)) result.AddError(Wording.Get("Send.InvalidCount", name, word, max));
        });
        return option;
    }

    private static Option<string> Text(string name, string description)
    {
        var option = new Option<string>(name) { HelpName = "TEXT", Description = description, DefaultValueFactory = _ => "" };
        option.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: var word }] && SendFormat.Unescape(word) is null) result.AddError(Wording.Get("Send.InvalidText", name, word));
        });
        return option;
    }
}

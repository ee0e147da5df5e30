using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Machines;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver commission</c>: runs CNCCOMMISSION with typed or piped answers, one on a line.</summary>
internal sealed class CommissionVerb
{
    private readonly VerbHost _host;
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Hand.Connect"));
    private readonly Option<string?> _profile = new("--machine") { HelpName = "PROFILE.json", Description = Wording.Get("Commission.Machine") };
    private readonly Option<string?> _output = new("--output", "-o") { HelpName = "PROFILE.json", Description = Wording.Get("Commission.Output") };

    private CommissionVerb(VerbHost host) => _host = host;

    public static Command Build(VerbHost host)
    {
        var verb = new CommissionVerb(host);
        var command = new MachineCommand("commission", Wording.Get("Commission.Summary")) { verb._connect, verb._profile, verb._output };
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var telling = new ScriptOutput(_host.Out, _host.Error, _host.Quiet(parsed), _host.Verbose(parsed));
        var environment = new CommandEnvironment { Terminology = SettingWording.OnConsole };
        if (parsed.GetValue(_output) is { } output) environment = environment with { CommissionedProfile = output };
        await using var session = new CommandSession(environment, CommandCatalog.Built());
        session.MessageWritten += telling.Write;
        await using var pressed = stop.Register(() => session.Machine.Controls.Stop()).ConfigureAwait(false);
        var result = parsed.GetValue(_profile) is { } profile ? await TypeAsync(session, stop, "CNCPROFILE", profile).ConfigureAwait(false) : new InputResult.Done();
        if (result is not InputResult.Done) return CodeOf(result, stop);
        await session.Machine.Connection.ConnectAsync(parsed.GetRequiredValue(_connect)!, stop).ConfigureAwait(false);
        return CodeOf(await ConverseAsync(session, stop).ConfigureAwait(false), stop);
    }

    private static async Task<InputResult> TypeAsync(CommandSession session, CancellationToken stop, params string[] inputs)
    {
        InputResult result = new InputResult.Done();
        foreach (var input in inputs) result = await session.EnterAsync(input, stop).ConfigureAwait(false);
        return result;
    }

    /// <summary>Asks until the command has ended. The end of the input acts as Esc: the machine is restored to its initial state.</summary>
    private async Task<InputResult> ConverseAsync(CommandSession session, CancellationToken stop)
    {
        var result = await session.EnterAsync("CNCCOMMISSION", stop).ConfigureAwait(false);
        while (result is InputResult.AwaitingInput or InputResult.NotAccepted)
        {
            if (await AnswerAsync(session.Prompt.Text, stop).ConfigureAwait(false) is not { } answer)
            {
                var asked = session.Prompt.Text;
                await session.CancelAsync().ConfigureAwait(false);
                stop.ThrowIfCancellationRequested();
                return new InputResult.Failed(CommandFailure.Usage, Translate(Wording.Get("Commission.InputEnds", asked)));
            }

            result = await session.EnterAsync(answer, stop).ConfigureAwait(false);
        }

        return result;
    }

    private string Translate(string sentence)
    {
        _host.Error.WriteLine(sentence);
        return sentence;
    }

    /// <returns>Null at the end of the input, or after the operator's stop.</returns>
    private async Task<string?> AnswerAsync(string prompt, CancellationToken stop)
    {
        if (_host.Interactive) await _host.Out.WriteAsync(prompt + " ").ConfigureAwait(false);
        else await _host.Out.WriteLineAsync(prompt).ConfigureAwait(false);
        await _host.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
        try
        {
            return await _host.ReadLineAsync(stop).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            return null;
        }
    }

    private static int CodeOf(InputResult result, CancellationToken stop) => result switch
    {
        InputResult.Done => ExitCode.Done,
        InputResult.Failed { Exception: { } bug } => throw new InvalidOperationException($"A command broke: {bug.Message}", bug), // The crash report has the details.
        InputResult.Failed failed => ScriptVerb.Code(failed.Reason),
        InputResult.Cancelled => throw new OperationCanceledException(stop),
        _ => ExitCode.Usage,
    };
}

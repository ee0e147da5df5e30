using System.CommandLine;
using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Cli.Verbs;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Settings;

namespace Engraver.Cli;

/// <summary>One run of <c>engraver</c>: parses the arguments, runs the verb, converts a failure to one sentence and an exit code.</summary>
public static class EngraverProgram
{
    /// <summary>Runs the program.</summary>
    /// <returns>The exit code (<see cref="ExitCode"/>).</returns>
    /// <remarks>Ctrl-C and SIGTERM end the program soon (<see cref="StoppableVerb"/>). While a machine is connected they cancel the verb and wait until the
    /// machine has stopped: the two-second limit of System.CommandLine is disabled, and a second signal has no effect.</remarks>
    public static async Task<int> RunAsync(string[] args, ConsoleStreams streams)
    {
        var stop = new CancellationTokenSource(); // Not disposed: a second signal may arrive at any time.
        InterruptSignal.RestoreDefault();
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);
        using var owned = streams;
        return await RunAsync(args, streams, stop.Token).ConfigureAwait(false);

        void Cancel(PosixSignalContext context)
        {
            context.Cancel = true;
            stop.Cancel();
        }
    }

    /// <summary>Runs the program; the token is the operator's stop.</summary>
    public static async Task<int> RunAsync(string[] args, ConsoleStreams streams, CancellationToken stop)
    {
        try
        {
            var code = await InvokeAsync(args, streams, stop).ConfigureAwait(false);
            await streams.Out.FlushAsync(CancellationToken.None).ConfigureAwait(false);
            return code;
        }
        catch (UsageException wrong)
        {
            return WriteError(streams, wrong.Message, ExitCode.Usage);
        }
        catch (SettingException wrong)
        {
            return WriteError(streams, wrong.Message, ExitCode.Usage);
        }
        catch (MachineUnavailableException unavailable)
        {
            return WriteError(streams, unavailable.Message, ExitCode.Refused);
        }
        catch (ControllerException link)
        {
            return WriteError(streams, link.Message, ExitCode.LinkLost);
        }
        catch (OperationCanceledException) when (stop.IsCancellationRequested)
        {
            return WriteError(streams, Wording.Get("EngraverProgram.StoppedOperator"), ExitCode.StoppedByOperator);
        }
        catch (IOException unwritable)
        {
            return WriteError(streams, Wording.Get("EngraverProgram.ResultNotWritable", SystemErrorText.FromException(unwritable)), ExitCode.DrawingError);
        }
        catch (Exception bug)
        {
            return WriteError(streams, CrashReport.Write(bug, args), ExitCode.InternalError);
        }
    }

    private static async Task<int> InvokeAsync(string[] args, ConsoleStreams streams, CancellationToken stop)
    {
        if (GlobalOptions.Language(args) is { } language) CultureInfo.CurrentUICulture = language;
        var global = new GlobalOptions();
        var machine = new ConnectionGuard();
        var root = EngraverCommandLine.Build(streams, global, machine);
        var parsed = root.Parse(args);
        if (WhyUnusable(args, root, parsed) is { } why)
        {
            RunVerb.ReportUnusable(parsed, streams.Out);
            return WriteError(streams, Wording.Get("EngraverProgram.SeeEngraverHelp", why), ExitCode.Usage);
        }

        var settings = new InvocationConfiguration
        {
            EnableDefaultExceptionHandler = false,
            ProcessTerminationTimeout = null,
            Output = streams.Out,
            Error = streams.Error,
        };
        if (parsed.CommandResult.Command is MachineCommand) machine.SetConnected(true);
        return await StoppableVerb.RunAsync(() => parsed.InvokeAsync(settings, stop), streams, machine, stop).ConfigureAwait(false);
    }

    /// <summary>Why the arguments are invalid; null when they are valid.</summary>
    private static string? WhyUnusable(string[] args, RootCommand root, ParseResult parsed)
    {
        if (VerbSuggestion.For(args, root) is { } verb) return verb;
        if (UnknownOption.In(parsed) is { } unknown) return unknown;
        if (parsed.Errors.Count > 0) return OneLine(parsed.Errors[0].Message);
        return EmptyName.In(parsed) is { } empty ? Wording.Get("EngraverProgram.EmptyName", empty) : null;
    }

    private static int WriteError(ConsoleStreams streams, string sentence, int code)
    {
        streams.Error.WriteLine($"engraver: {sentence}");
        return code;
    }

    /// <summary>A message of System.CommandLine, which spreads the allowed values over several lines, as one line.</summary>
    private static string OneLine(string message) => string.Join(' ', message.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
}

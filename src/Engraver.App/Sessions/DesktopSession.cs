using Engraver.App.Desk;
using Engraver.App.Plots;
using Engraver.App.Safety;
using Engraver.App.Texts;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Reports;

namespace Engraver.App.Sessions;

/// <summary>The parts of the desktop without its window: a command session with the operator's files, the desktop model for it, the stop keys.</summary>
public sealed class DesktopSession : IAsyncDisposable
{
    private readonly CommandSession _session;
    private DesktopModel? _desk;

    public DesktopSession(CommandEnvironment environment)
    {
        ArgumentNullException.ThrowIfNull(environment);
        Time = environment.Time;
        FailureReports = new FailureReports(Path.GetDirectoryName(environment.SettingsFile) ?? UserFiles.Folder, environment.Time);
        _session = new CommandSession(environment with { Failures = FailureReports, PlotRenderer = new PlotRenderer() }, CommandCatalog.Built());
        StopKeys = new StopKeys(() => DesktopModel.Moves(_session.Machine), () => _session.Machine.Controls.Stop(), HoldOrStop);
    }

    public TimeProvider Time { get; }

    /// <summary>Any thread.</summary>
    public StopKeys StopKeys { get; }

    /// <summary>Stored beside the settings.</summary>
    public FailureReports FailureReports { get; }

    /// <summary>Any thread.</summary>
    public FailureGuard Failures => field ??= new FailureGuard(() => StopKeys.PressStop(), _session.Machine.Alarms, FailureReports);

    /// <summary>Code of the language set by LANGUAGE; null: that of the system.</summary>
    public string? Language => _session.Settings.Current.Language;

    /// <summary>State of the platform for this session; used only by the platform.</summary>
    internal object? PlatformState { get; set; }

    /// <summary>Created on the UI thread on first access.</summary>
    public DesktopModel Desk => _desk ??= new DesktopModel(_session, Time);

    /// <summary>Uses the operator's own files.</summary>
    public static CommandEnvironment ForUser() => new() { AliasFile = UserFiles.Aliases, SettingsFile = UserFiles.DesktopSettingsFile, RunNeedsArming = true, SimulatorSpeed = 1.0 };

    /// <summary>Stores nothing: a picture must not depend on how an operator left the window, nor change it.</summary>
    public static CommandEnvironment WithoutFiles() => ForUser() with { SettingsFile = null, KeepsHistory = false };

    /// <summary>The display is gone, and with it the operator's controls: stops the machine first; the journal of the job states the reason. Any thread;
    /// does not wait.</summary>
    /// <returns>What happened and what to do, for the person who started the program.</returns>
    public string HandleDisplayLoss()
    {
        var moved = DesktopModel.Moves(_session.Machine);
        var what = Text.Get(moved ? "Failure.DisplayLostInMotion" : "Failure.DisplayLost");
        _session.Machine.Controls.Stop(what);
        _session.Machine.Alarms.Raise(AlarmCause.DisplayLost, what, Text.Get("Failure.Display"), Text.Get("Failure.DisplayAdvice"));
        return moved ? $"{what} {Text.Get("Failure.DisplayAdvice")}" : what;
    }

    /// <summary>Motion that cannot be held, such as a move by hand, is stopped.</summary>
    private void HoldOrStop()
    {
        if (!_session.Machine.Controls.HoldJob()) _session.Machine.Controls.Stop();
    }

    public ValueTask DisposeAsync() => _desk?.DisposeAsync() ?? _session.DisposeAsync();
}

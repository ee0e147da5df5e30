using Engraver.Workbench.Composition;
using Engraver.Workbench.Plots;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>The environment of a command session: folders, files and switches. Tests use other values.</summary>
public sealed record CommandEnvironment
{
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>The controller families that machine profiles may name and addresses may reach.</summary>
    public MachineFamilies Families { get; init; } = MachineFamilies.Standard;

    /// <summary>Folder for relative file names.</summary>
    public string Folder { get; init; } = Directory.GetCurrentDirectory();

    /// <summary>File of the operator's aliases, which override the built-in ones; it need not exist. Null: none.</summary>
    public string? AliasFile { get; init; }

    /// <summary>Receives every input, one on a line; the text is a script that repeats the session. Null: not recorded.</summary>
    public TextWriter? Journal { get; init; }

    /// <summary>Folder of run journals without an explicit path; null: the operator's data folder.</summary>
    public string? RunJournalFolder { get; init; }

    /// <summary>True to save the history of jobs beside the journals; otherwise it is lost when the session ends.</summary>
    public bool KeepsHistory { get; init; } = true;

    /// <summary>File of the desktop's settings; null: they are lost when the session ends.</summary>
    public string? SettingsFile { get; init; }

    /// <summary>Names the settings and commands of a text, <c>[zero]</c>, as the current front end does (<see cref="SettingWording"/>).</summary>
    public Func<string, string> Terminology { get; init; } = SettingWording.AtCommandLine;

    /// <summary>Default file name of the machine profile that CNCCOMMISSION creates.</summary>
    public string CommissionedProfile { get; init; } = "machine.json";

    /// <summary>Reports of internal errors; null: only in the command history.</summary>
    public FailureReports? Failures { get; init; }

    /// <summary>Draws plots into pictures; null where the front end has no graphics library.</summary>
    public IPlotRenderer? PlotRenderer { get; init; }

    /// <summary>Speed of a simulated controller whose address does not define it: controller seconds per wall-clock second; infinity for the maximum speed. The
    /// desktop uses real time.</summary>
    public double SimulatorSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>True at a desktop, where the operator starts jobs: CNCRUN then works only when armed (on a simulated controller a script may run it unarmed),
    /// and no script starts a machine that is not simulated.</summary>
    public bool RunNeedsArming { get; init; }
}

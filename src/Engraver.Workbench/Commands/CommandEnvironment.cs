using Engraver.Workbench.Composition;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands;

/// <summary>The folders, files and switches that a command session is given from outside; a test gives it others.</summary>
public sealed record CommandEnvironment
{
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>The controller families that machine profiles may name and addresses may reach.</summary>
    public MachineFamilies Families { get; init; } = MachineFamilies.Standard;

    /// <summary>File names that are not rooted are looked for and written here.</summary>
    public string Folder { get; init; } = Directory.GetCurrentDirectory();

    /// <summary>The operator's own aliases, over the built-in ones; the file need not exist. Null: none.</summary>
    public string? AliasFile { get; init; }

    /// <summary>Where every input is written, one on a line, so that the text is a script that does the same again. Null: nowhere.</summary>
    public TextWriter? Journal { get; init; }

    /// <summary>Where run journals go when no file is named; null: the operator's data folder.</summary>
    public string? RunJournalFolder { get; init; }

    /// <summary>Whether the history of jobs is kept, beside the journals; otherwise it lives as long as the session.</summary>
    public bool KeepsHistory { get; init; } = true;

    /// <summary>Where the desktop's settings are kept; null: they live as long as the session.</summary>
    public string? SettingsFile { get; init; }

    /// <summary>Names the settings and commands of a text, <c>[zero]</c>, in the words of where it is read (<see cref="SettingWording"/>).</summary>
    public Func<string, string> Speech { get; init; } = SettingWording.AtCommandLine;

    /// <summary>The file that CNCCOMMISSION offers for the machine profile it ends with.</summary>
    public string CommissionedProfile { get; init; } = "machine.json";

    /// <summary>Where a bug is reported; null: in the history only.</summary>
    public FailureReports? Failures { get; init; }

    /// <summary>How fast a simulated controller runs whose address does not say it: controller seconds per second of the wall, infinity as fast as it can
    /// be computed. An operator at a desktop sees the machine move as it would.</summary>
    public double SimulatorSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>True at a desktop, where a person starts jobs: CNCRUN then works only when armed (on a simulated controller a script may run it unarmed),
    /// and no script starts a machine that is not simulated.</summary>
    public bool RunNeedsArming { get; init; }
}

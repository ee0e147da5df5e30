using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Histories;

/// <summary>One job in the history: a run or a posted program. The date is stored here and not in the journal, so that equal runs have equal
/// journals.</summary>
public sealed record HistoryEntry
{
    /// <summary>The version of entries that this program writes.</summary>
    public const int CurrentVersion = 1;

    public int Version { get; init; } = CurrentVersion;

    /// <summary>Its name, which is also its file name.</summary>
    [JsonIgnore]
    public string Id { get; init; } = "";

    /// <summary>Start time, UTC.</summary>
    public required DateTimeOffset Date { get; init; }

    /// <summary>run, dryRun, simulation or post.</summary>
    public required string Kind { get; init; }

    /// <summary>Full path of the drawing.</summary>
    public required string Drawing { get; init; }

    /// <summary>SHA-256 of its file at that time; null if it could not be read again.</summary>
    public string? DrawingSha256 { get; init; }

    /// <summary>The trajectories of the drawing were run instead of the drawing.</summary>
    public bool RanTrajectories { get; init; }

    /// <summary>Name of the post; for a run the post of the program sent to the machine.</summary>
    public required string Target { get; init; }

    /// <summary>Post options other than the settings, such as dialect and style, by name; empty if all are defaults.</summary>
    public IReadOnlyDictionary<string, string> Options { get; init; } = new Dictionary<string, string>();

    /// <summary>Result of the last read-back of <see cref="Program"/>; null if there was none.</summary>
    public HistoryReadBack? ReadBack { get; init; }

    /// <summary>The values of the texts of the plate and its place (<see cref="SerialTexts.Plate.ToString"/>); null for a job without.</summary>
    public string? Plate { get; init; }

    /// <summary>stream, calls or program; null for a posted program.</summary>
    public string? Mode { get; init; }

    /// <summary>Address of the controller; null for a posted program.</summary>
    public string? Address { get; init; }

    /// <summary>As in <c>run --json</c>; <c>written</c> for a program; <c>begun</c> for a run that is active or whose process was killed.</summary>
    public required string Outcome { get; init; }

    /// <summary>The result as a displayed sentence; may be empty.</summary>
    public string Sentence { get; init; } = "";

    /// <summary>Controller time of a run; null for a program.</summary>
    public double? Seconds { get; init; }

    public double? PlannedSeconds { get; init; }

    /// <summary>Millimetres; null when unknown.</summary>
    public double? MaxDeviation { get; init; }

    public double? MissingLength { get; init; }

    /// <summary>Largest deviation where corners were rounded, millimetres; null when unknown or without a corner tolerance.</summary>
    public double? CornerDeviation { get; init; }

    /// <summary>What was measured of each operation; null without operations, and where it is unknown.</summary>
    public IReadOnlyList<MeasuredOperation>? Operations { get; init; }

    /// <summary>Those of X, Y and Z for which <see cref="MaxDeviation"/> is based on commanded positions, because steppers have no feedback; null for
    /// none.</summary>
    public IReadOnlyList<char>? OpenLoop { get; init; }

    /// <summary>Full path; null if there is none or it was written to a stream.</summary>
    public string? Journal { get; init; }

    /// <summary>Full path of the posted program; null for none.</summary>
    public string? Program { get; init; }

    /// <summary>Full path of its last report; null for none.</summary>
    public string? Report { get; init; }

    /// <summary>The start checks; null if they were not run.</summary>
    public IReadOnlyList<HistoryCheck>? Checks { get; init; }

    /// <summary>By the keys of docs/settings.md.</summary>
    public required IReadOnlyDictionary<string, string> Settings { get; init; }

    /// <summary>The fonts of the texts that were cut; null if none was.</summary>
    public IReadOnlyList<CutFont>? Fonts { get; init; }

    /// <summary>The machine profile in its full form.</summary>
    public JsonElement Profile { get; init; }

    /// <summary>The settings with which the job can be run again.</summary>
    /// <param name="families">The controller families that the profile may name.</param>
    /// <exception cref="FormatException">The stored settings or profile are invalid.</exception>
    public DrawingSettings ToSettings(MachineFamilies families)
    {
        ArgumentNullException.ThrowIfNull(families);
        var machine = Profile.ValueKind != JsonValueKind.Object ? MachineProfile.Default
            : families.ReadProfile(Profile.GetRawText()) is { Profile: { } read } ? read : throw new FormatException(Wording.Get("History.InvalidProfile"));
        return SettingValues.Read(Settings, machine);
    }

    /// <summary>Like <see cref="JobIdentity.Profile"/>; null if the stored profile is invalid.</summary>
    internal string? ProfileHash(MachineFamilies families) => Profile.ValueKind == JsonValueKind.Object && families.ReadProfile(Profile.GetRawText()).Profile is { } machine ? JobIdentity.OfProfile(machine) : null;

    /// <summary>Whether the displayed text of the job contains a word.</summary>
    public bool Matches(string word) =>
        ((string?[])[Id, Drawing, Kind, Target, Mode, Address, Outcome, Sentence, Plate, Journal, Program, .. Options.Select(option => $"{option.Key} {option.Value}"), ReadBack is null ? null : ReadBackWord(ReadBack), string.Create(CultureInfo.InvariantCulture, $"{Date.UtcDateTime:yyyy-MM-dd} {Date.UtcDateTime:HH:mm}")]).Any(text => text?.Contains(word, StringComparison.OrdinalIgnoreCase) == true);

    /// <summary>certified, verified or notVerified: the word used in lists and searches.</summary>
    public static string ReadBackWord(HistoryReadBack readBack)
    {
        ArgumentNullException.ThrowIfNull(readBack);
        return (readBack.Ok, readBack.Certificate) switch { (true, not null) => "certified", (true, null) => "verified", _ => "notVerified" };
    }

    /// <summary>Creates the entry of a run.</summary>
    /// <param name="simulated">It ran on a separate simulated machine (CNCSIM).</param>
    /// <param name="checks">The start checks.</param>
    public static HistoryEntry OfRun(PreparedJob job, MachineRunOptions options, MachineRunReport report, DateTimeOffset date, bool simulated, ArmingChecklist? checks)
    {
        ArgumentNullException.ThrowIfNull(report);
        return CreateRun(job, options, report.Result.Outcome, date, simulated, checks) with
        {
            Sentence = report.Result.Message,
            Seconds = report.Result.Seconds,
            PlannedSeconds = report.PlannedSeconds,
            MaxDeviation = report.Judgement.MaxDeviationMm,
            MissingLength = report.Judgement.MissingLengthMm,
            CornerDeviation = report.Judgement.CornerDeviationMm,
            Operations = report.Judgement.Operations.Count == 0 ? null : report.Judgement.Operations,
            OpenLoop = report.Judgement.MaxDeviationMm is null || report.CommandedOnly.Count == 0 ? null : report.CommandedOnly,
        };
    }

    /// <summary>Creates the entry of a run that starts now.</summary>
    public static HistoryEntry OfStarted(PreparedJob job, MachineRunOptions options, DateTimeOffset date, bool simulated) => CreateRun(job, options, JobOutcome.LinkLost, date, simulated, checks: null) with { Outcome = "begun", Sentence = Wording.Get("History.Unfinished") };

    /// <summary>Creates the entry of a run that could not connect to the machine.</summary>
    public static HistoryEntry OfLost(PreparedJob job, MachineRunOptions options, string sentence, DateTimeOffset date) => CreateRun(job, options, JobOutcome.LinkLost, date, simulated: false, checks: null) with { Sentence = sentence };

    /// <summary>Creates the entry of a posted program.</summary>
    /// <param name="options">Options of the post.</param>
    /// <param name="file">Its path; null for standard output.</param>
    public static HistoryEntry OfPost(Drawing drawing, DrawingSettings settings, string target, IReadOnlyDictionary<string, string> options, string? file, DateTimeOffset date) => new()
    {
        Date = date.ToUniversalTime(),
        Kind = "post",
        Drawing = Path.GetFullPath(drawing.FileName),
        DrawingSha256 = ContentHash.OfFile(drawing.FileName),
        Target = target,
        Options = options,
        Outcome = "written",
        Program = file is null ? null : Path.GetFullPath(file),
        Settings = SettingValues.Of(settings.AsOpened(drawing)),
        Fonts = FontsOf(JobPreparation.To<LetteredJob>(drawing, settings).Letters.Fonts),
        Profile = ProfileOf(settings),
    };

    private static HistoryEntry CreateRun(PreparedJob job, MachineRunOptions options, JobOutcome outcome, DateTimeOffset date, bool simulated, ArmingChecklist? checks)
    {
        ArgumentNullException.ThrowIfNull(options);
        var driver = MachineFamilies.DriverOf(job.Settings.Machine);
        return OfPost(job.DocumentDrawing, job.Trajectories?.Settings ?? job.Settings, PostTable.ForMotion(driver, options.Strategy.Style)?.Post.Name ?? driver.Key, PostedProgram.NoOptions, file: null, date) with
        {
            Kind = simulated ? "simulation" : options.DryRun ? "dryRun" : "run",
            RanTrajectories = job.Trajectories is not null,
            Plate = job.Plate?.ToString(),
            Fonts = FontsOf(job.Fonts),
            Mode = options.Strategy.Key,
            Address = options.Address.Typed,
            Outcome = OutcomeText.Token(outcome),
            Journal = Path.GetFullPath(options.JournalPath),
            Checks = checks is null ? null : [.. checks.Checks.Select(check => new HistoryCheck(check.Passed, check.IsWarning, check.Message))],
        };
    }

    private static IReadOnlyList<CutFont>? FontsOf(IReadOnlyList<CutFont> fonts) => fonts.Count == 0 ? null : fonts;

    private static JsonElement ProfileOf(DrawingSettings settings)
    {
        using var document = JsonDocument.Parse(MachineProfileFile.Write(settings.Machine));
        return document.RootElement.Clone();
    }
}

/// <summary>The common part of all versions of an entry.</summary>
internal sealed record HistoryVersion(int Version = HistoryEntry.CurrentVersion);

/// <summary>One start check.</summary>
public sealed record HistoryCheck(bool Ok, bool Warning, string Sentence);

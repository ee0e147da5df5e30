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
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Histories;

/// <summary>One job in the history: a run, or a program that was written. The date stands here and not in the journal, so that two equal runs have equal
/// journals.</summary>
public sealed record HistoryEntry
{
    /// <summary>The form of the entries that this program writes.</summary>
    public const int CurrentVersion = 1;

    public int Version { get; init; } = CurrentVersion;

    /// <summary>By what it is named; the name of its file.</summary>
    [JsonIgnore]
    public string Id { get; init; } = "";

    /// <summary>When it began, UTC.</summary>
    public required DateTimeOffset Date { get; init; }

    /// <summary>run, dryRun, simulation or post.</summary>
    public required string Kind { get; init; }

    /// <summary>Full path of the drawing.</summary>
    public required string Drawing { get; init; }

    /// <summary>SHA-256 of its file at that time; null where it could not be read again.</summary>
    public string? DrawingSha256 { get; init; }

    /// <summary>The trajectories of the drawing were run instead of the drawing.</summary>
    public bool RanTrajectories { get; init; }

    /// <summary>Name of the post; of a run the one whose program the machine was sent.</summary>
    public required string Target { get; init; }

    /// <summary>What was chosen for the post beside the settings: dialect, style and the others, by name; empty where everything was as usual.</summary>
    public IReadOnlyDictionary<string, string> Options { get; init; } = new Dictionary<string, string>();

    /// <summary>How <see cref="Program"/> stood to its drawing when it was read back last; null where nobody did.</summary>
    public HistoryReadBack? ReadBack { get; init; }

    /// <summary>stream, calls or program; null for a program that was written.</summary>
    public string? Mode { get; init; }

    /// <summary>Where the controller was; null for a program that was written.</summary>
    public string? Address { get; init; }

    /// <summary>As <c>run --json</c> has it; of a program <c>written</c>; <c>begun</c> of a run that has no end yet, or never got one because its program
    /// was killed.</summary>
    public required string Outcome { get; init; }

    /// <summary>How it ended, for people; empty where there is nothing to say.</summary>
    public string Sentence { get; init; } = "";

    /// <summary>Controller time of a run; null for a program.</summary>
    public double? Seconds { get; init; }

    public double? PlannedSeconds { get; init; }

    /// <summary>Millimetres; null where nothing is known.</summary>
    public double? MaxDeviation { get; init; }

    public double? MissingLength { get; init; }

    /// <summary>X, Y and Z as far as <see cref="MaxDeviation"/> is that of what was commanded, because steppers moved them and nothing tells whether they
    /// followed; null for none.</summary>
    public IReadOnlyList<char>? OpenLoop { get; init; }

    /// <summary>Full path; null where there is none, or where it went into a stream.</summary>
    public string? Journal { get; init; }

    /// <summary>Full path of the program that was written; null for none.</summary>
    public string? Program { get; init; }

    /// <summary>Full path of the last report that was made of it; null for none.</summary>
    public string? Report { get; init; }

    /// <summary>The list before the start; null where nobody went through it.</summary>
    public IReadOnlyList<HistoryCheck>? Checks { get; init; }

    /// <summary>By the keys of docs/settings.md.</summary>
    public required IReadOnlyDictionary<string, string> Settings { get; init; }

    /// <summary>The machine profile in its full form.</summary>
    public JsonElement Profile { get; init; }

    /// <summary>The settings with which the job can be run again.</summary>
    /// <exception cref="FormatException">What was kept is no setting, or no profile that this program takes.</exception>
    public DrawingSettings ToSettings()
    {
        var machine = Profile.ValueKind != JsonValueKind.Object ? MachineProfile.Default
            : MachineProfileFile.Read(Profile.GetRawText(), MachineFamilies.Driver.Limits) is { Profile: { } read } ? read : throw new FormatException(Wording.Get("History.InvalidProfile"));
        return SettingWords.Read(Settings, machine);
    }

    /// <summary>As <see cref="JobIdentity.Profile"/>; null where what was kept is no profile that this program takes.</summary>
    internal string? ProfileHash => Profile.ValueKind == JsonValueKind.Object && MachineProfileFile.Read(Profile.GetRawText(), MachineFamilies.Driver.Limits).Profile is { } machine ? JobIdentity.OfProfile(machine) : null;

    /// <summary>Whether a word is found in what people know a job by.</summary>
    public bool Holds(string word) =>
        ((string?[])[Id, Drawing, Kind, Target, Mode, Address, Outcome, Sentence, Journal, Program, .. Options.Select(option => $"{option.Key} {option.Value}"), ReadBack is null ? null : ReadBackWord(ReadBack), string.Create(CultureInfo.InvariantCulture, $"{Date.UtcDateTime:yyyy-MM-dd} {Date.UtcDateTime:HH:mm}")]).Any(text => text?.Contains(word, StringComparison.OrdinalIgnoreCase) == true);

    /// <summary>certified, verified or notVerified: as lists show it, and as it is searched for.</summary>
    public static string ReadBackWord(HistoryReadBack readBack)
    {
        ArgumentNullException.ThrowIfNull(readBack);
        return (readBack.Ok, readBack.Certificate) switch { (true, not null) => "certified", (true, null) => "verified", _ => "notVerified" };
    }

    /// <summary>A run.</summary>
    /// <param name="simulated">A simulated machine of its own ran it (CNCSIM).</param>
    /// <param name="checks">The list before the start.</param>
    public static HistoryEntry OfRun(PreparedJob job, MachineRunOptions options, MachineRunReport report, DateTimeOffset date, bool simulated, ArmingChecklist? checks)
    {
        ArgumentNullException.ThrowIfNull(report);
        return Begun(job, options, report.Result.Outcome, date, simulated, checks) with
        {
            Sentence = report.Result.Sentence,
            Seconds = report.Result.Seconds,
            PlannedSeconds = report.PlannedSeconds,
            MaxDeviation = report.Judgement.MaxDeviationMm,
            MissingLength = report.Judgement.MissingLengthMm,
            OpenLoop = report.Judgement.MaxDeviationMm is null || report.Unseen.Count == 0 ? null : report.Unseen,
        };
    }

    /// <summary>A run that begins now.</summary>
    public static HistoryEntry OfBegun(PreparedJob job, MachineRunOptions options, DateTimeOffset date, bool simulated) => Begun(job, options, JobOutcome.LinkLost, date, simulated, checks: null) with { Outcome = "begun", Sentence = Wording.Get("History.Unfinished") };

    /// <summary>A run that never got hold of the machine.</summary>
    public static HistoryEntry OfLost(PreparedJob job, MachineRunOptions options, string sentence, DateTimeOffset date) => Begun(job, options, JobOutcome.LinkLost, date, simulated: false, checks: null) with { Sentence = sentence };

    /// <summary>A program.</summary>
    /// <param name="options">What was chosen for the post.</param>
    /// <param name="file">Where it was written; null for standard output.</param>
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
        Settings = SettingWords.Of(settings.AsOpened(drawing)),
        Profile = ProfileOf(settings),
    };

    private static HistoryEntry Begun(PreparedJob job, MachineRunOptions options, JobOutcome outcome, DateTimeOffset date, bool simulated, ArmingChecklist? checks)
    {
        ArgumentNullException.ThrowIfNull(options);
        return OfPost(job.DocumentDrawing, job.Followed?.Settings ?? job.Settings, PostTable.ForMotion(JobPlan.StyleOf(options.Mode)).Post.Name, PostedProgram.NoOptions, file: null, date) with
        {
            Kind = simulated ? "simulation" : options.DryRun ? "dryRun" : "run",
            RanTrajectories = job.Followed is not null,
            Mode = options.Mode switch { JobMode.Calls => "calls", JobMode.Program => "program", _ => "stream" },
            Address = options.Address.Typed,
            Outcome = OutcomeText.Word(outcome),
            Journal = Path.GetFullPath(options.JournalPath),
            Checks = checks is null ? null : [.. checks.Checks.Select(check => new HistoryCheck(check.Passed, check.IsWarning, check.Sentence))],
        };
    }

    private static JsonElement ProfileOf(DrawingSettings settings)
    {
        using var document = JsonDocument.Parse(MachineProfileFile.Write(settings.Machine));
        return document.RootElement.Clone();
    }
}

/// <summary>What every version of an entry has, whatever its form.</summary>
internal sealed record HistoryVersion(int Version = HistoryEntry.CurrentVersion);

/// <summary>How a program stood to its drawing when it was read back.</summary>
/// <param name="Date">When, UTC.</param>
/// <param name="MaxDeviation">Millimetres; null where nothing is known.</param>
/// <param name="Certificate">Full path of the certificate that was written of it; null for none.</param>
public sealed record HistoryReadBack(bool Ok, DateTimeOffset Date, double? MaxDeviation, string? Certificate);

/// <summary>A line of the list before a start.</summary>
public sealed record HistoryCheck(bool Ok, bool Warning, string Sentence);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", RespectNullableAnnotations = true)]
[JsonSerializable(typeof(HistoryEntry))]
[JsonSerializable(typeof(HistoryVersion))]
internal sealed partial class HistoryJson : JsonSerializerContext;

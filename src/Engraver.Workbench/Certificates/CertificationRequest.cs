using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Certificates;

/// <summary>What is to be certified.</summary>
/// <param name="Drawing">The drawing as read.</param>
/// <param name="DrawingHash">Hash of its file, taken before reading: if the file changes meanwhile, the certificate is stale.</param>
/// <param name="Target">An entry whose programs can be read back.</param>
/// <param name="Now">The date of the certificate.</param>
public sealed record CertificationRequest(Drawing Drawing, string? DrawingHash, DrawingSettings Settings, PostEntry Target, DateTimeOffset Now)
{
    /// <summary>An existing program with its file name; null: it is posted now.</summary>
    public (string File, string Text)? Program { get; init; }

    /// <summary>Post parameters of that program that affect its verification; null for the defaults.</summary>
    public PostParameters? PostParameters { get; init; }

    /// <summary>The kind of controller that the program is written for and by whose rules it is read back; null for the default of the target.</summary>
    public string? Dialect { get; init; }

    /// <summary>The reader of the target and the dialect; null if there is none.</summary>
    internal IProgramReader? Reader => Dialect is null ? Target.Reader : Target.Dialects[Dialect];

    /// <summary>Post options that affect the program.</summary>
    public IReadOnlyDictionary<string, string> Options => Dialect is null ? PostedProgram.NoOptions : new Dictionary<string, string> { ["dialect"] = Dialect };

    /// <summary>What the fields in texts stand for.</summary>
    public PlateValues Values { get; init; } = PlateValues.None;

    /// <summary>The link to the machine, which may limit the feed; null for none.</summary>
    public ControllerAddress? Address { get; init; }

    /// <summary>How the machine runs it; the driver's default where it is not set.</summary>
    public ExecutionStrategy Strategy
    {
        get => field ?? MachineFamilies.DriverOf(Settings.Machine).DefaultStrategy;
        init;
    }
}

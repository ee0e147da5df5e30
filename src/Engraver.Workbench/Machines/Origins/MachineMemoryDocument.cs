using System.Text.Json;
using System.Text.Json.Nodes;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The stored state of a machine in its file, counts of the controller.</summary>
/// <remarks>Missing members have the default values below; with init-only properties they would be null.</remarks>
internal sealed record MachineMemoryDocument
{
    public string Machine { get; set; } = "";

    public string Active { get; set; } = WorkOriginNames.First;

    public Dictionary<string, OriginDocument?> Origins { get; set; } = [];

    public int? Mark { get; set; }

    public double? Clock { get; set; }

    public long? RestX { get; set; }

    public long? RestY { get; set; }

    public int? RestZ { get; set; }

    public bool Moving { get; set; }

    public string? Lost { get; set; }

    public string? HomedAs { get; set; }

    public ScaleDocument? HomedCountsPerMillimetre { get; set; }

    /// <summary>The first 64 bits of SHA-256 over the other members; null in files of an older version.</summary>
    public string? Sum { get; set; }

    /// <summary>The same with its checksum.</summary>
    public MachineMemoryDocument WithChecksum() => this with { Sum = ChecksumOf((this with { Sum = null }).ToJson()) };

    /// <exception cref="JsonException">It is not such a document.</exception>
    /// <exception cref="InvalidDataException">The checksum does not match.</exception>
    public static MachineMemoryDocument Read(string text)
    {
        var document = JsonSerializer.Deserialize(text, MachineMemoryJson.Default.MachineMemoryDocument) ?? throw new JsonException(Wording.Get("Origins.ContainsNull"));
        return document.Sum is null || document.Sum == ChecksumOf(text) ? document : throw new InvalidDataException(Wording.Get("Origins.ChecksumMismatch"));
    }

    public string ToJson() => JsonSerializer.Serialize(this, MachineMemoryJson.Default.MachineMemoryDocument);

    /// <summary>Covers every member except the checksum, also unknown ones; whitespace is ignored.</summary>
    private static string ChecksumOf(string json)
    {
        var members = JsonNode.Parse(json)!.AsObject();
        members.Remove("sum");
        return ContentHash.OfText(members.ToJsonString())[..16];
    }

    public static MachineMemoryDocument From(string machine, StoredMachineState memory) => new()
    {
        Machine = machine,
        Active = memory.Active,
        Origins = memory.Origins.ToDictionary(entry => entry.Key, OriginDocument? (entry) => new OriginDocument(entry.Value.X, entry.Value.Y, entry.Value.Z, entry.Value.IsAssumed, ScaleDocument.From(entry.Value.Axes), LettersDocument.From(entry.Value.Axes))),
        Mark = memory.Mark,
        Clock = memory.Clock,
        RestX = memory.RestPosition?.X,
        RestY = memory.RestPosition?.Y,
        RestZ = memory.RestPosition is { Z: not 0 and var height } ? height : null,
        Moving = memory.IsMoving,
        Lost = memory.Lost.Length == 0 ? null : memory.Lost,
        HomedAs = memory.HomedAs.Length == 0 ? null : memory.HomedAs,
        HomedCountsPerMillimetre = ScaleDocument.From(memory.HomedAxes),
    };

    public StoredMachineState ToMemory() => new()
    {
        Active = WorkOriginNames.Find(Active) ?? throw new JsonException(Wording.Get("Origins.UnknownOrigin", Active)),
        Origins = ReadOrigins(),
        Mark = Mark,
        Clock = Clock,
        RestPosition = RestX is { } x && RestY is { } y ? new CountsPoint(x, y, RestZ ?? 0) : null,
        IsMoving = Moving,
        Lost = Lost ?? "",
        HomedAs = HomedAs ?? "",
        HomedAxes = HomedCountsPerMillimetre?.ToAxes(null) ?? default,
    };

    private Dictionary<string, WorkOrigin> ReadOrigins()
    {
        var origins = new Dictionary<string, WorkOrigin>();
        foreach (var (key, document) in Origins)
        {
            var name = WorkOriginNames.Find(key) ?? throw new JsonException(Wording.Get("Origins.UnknownOrigin", key));
            if (document is null) throw new JsonException(Wording.Get("Origins.ContainsNull"));
            if (!origins.TryAdd(name, new WorkOrigin(document.X, document.Y, document.Z) { IsAssumed = document.Assumed, Axes = document.CountsPerMillimetre?.ToAxes(document.Axes) ?? default })) throw new JsonException(Wording.Get("Origins.Twice", name));
        }

        return origins;
    }

    /// <param name="Assumed">It was not set by the operator: the controller's position was 0 there.</param>
    /// <param name="CountsPerMillimetre">Null in files of an older version.</param>
    /// <param name="Axes">The controller's letters; null in files of an older version.</param>
    internal sealed record OriginDocument(long? X, long? Y, int? Z, bool Assumed, ScaleDocument? CountsPerMillimetre = null, LettersDocument? Axes = null);

    /// <summary>Scales of the drawing's axes.</summary>
    internal sealed record ScaleDocument(double? X, double? Y, double? Z)
    {
        public static ScaleDocument? From(StoredAxes axes) => axes == default ? null : new ScaleDocument(axes.X?.Counts, axes.Y?.Counts, axes.Z?.Counts);

        public StoredAxes ToAxes(LettersDocument? letters) => new(Axis(X, letters?.X), Axis(Y, letters?.Y), Axis(Z, letters?.Z));

        private static StoredAxis? Axis(double? counts, char? letter) => counts is { } known ? new StoredAxis(known, letter) : null;
    }

    /// <summary>The controller's letters of the drawing's axes.</summary>
    internal sealed record LettersDocument(char? X, char? Y, char? Z)
    {
        public static LettersDocument? From(StoredAxes axes) =>
            new LettersDocument(axes.X?.Letter, axes.Y?.Letter, axes.Z?.Letter) is var letters && letters == new LettersDocument(null, null, null) ? null : letters;
    }
}

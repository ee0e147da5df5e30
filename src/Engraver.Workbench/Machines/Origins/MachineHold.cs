using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>A machine leased by this host, with its state that is stored between sessions. Disposing releases it.</summary>
public sealed class MachineHold : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string? _path;
    private readonly string _name = "";
    private readonly MachineLock? _lock;
    private MachineMemory _memory = MachineMemory.Empty;
    private bool _knowsZero;
    private bool _isWritten = true;

    /// <summary>A machine without stored state.</summary>
    internal MachineHold()
    {
    }

    /// <exception cref="IOException">The file cannot be read, or is invalid.</exception>
    internal MachineHold(string path, string name, MachineLock taken)
    {
        (_path, _name, _lock) = (path, name, taken);
        try
        {
            if (File.Exists(path)) _memory = MachineMemoryDocument.Read(File.ReadAllText(path)).ToMemory();
        }
        catch (Exception unusable) when (unusable is JsonException or InvalidDataException or IOException or UnauthorizedAccessException)
        {
            taken.Dispose(); // Releases the machine.
            if (unusable is JsonException) throw new InvalidDataException(Wording.Get("Origins.InvalidRecord", SystemReason.Of(unusable)), unusable);
            throw;
        }
    }

    /// <summary>Whether the state is stored beyond this session.</summary>
    public bool IsKept => _path is not null;

    public MachineMemory Memory
    {
        get
        {
            lock (_guard) return _memory;
        }
    }

    /// <summary>Updates the known state of the machine. If it cannot be written, it is kept in memory and written with the next change.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? Keep(Func<MachineMemory, MachineMemory> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            (var before, _memory) = (_memory, change(_memory));
            return _memory == before && _isWritten ? null : Write(_memory);
        }
    }

    /// <summary>Stores a decision of the operator: if it cannot be written, nothing is changed.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? Set(Func<MachineMemory, MachineMemory> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            var next = change(_memory);
            if (Write(next) is { } failure) return failure;
            _memory = next;
            return null;
        }
    }

    private string? Write(MachineMemory memory)
    {
        if (_path is null) return null;
        try
        {
            OutputFile.Write(_path, output => output.WriteLine(MachineMemoryDocument.From(_name, memory).Sealed().ToJson()));
            _isWritten = true;
            return null;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            _isWritten = false;
            return SystemReason.Of(failure);
        }
    }

    /// <summary>True if the controller's zero is the stored one. Otherwise motion is not recorded, because it is unrelated to the stored zero.</summary>
    public bool KnowsZero
    {
        get
        {
            lock (_guard) return _knowsZero;
        }
    }

    /// <summary>True if the machine was homed by this profile and the controller's zero is unchanged as far as known.</summary>
    public bool IsHomed(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        lock (_guard) return _knowsZero && _memory.Lost.Length == 0 && _memory.WasHomedBy(profile);
    }

    /// <summary>For a simulated machine without stored state: it counts as homed, with its zero at the start position
    /// (<see cref="MachineMemory.AssumeHomed"/>).</summary>
    /// <exception cref="InvalidOperationException">The machine has stored state.</exception>
    public void AssumeHomed(MachineProfile profile)
    {
        if (IsKept) throw new InvalidOperationException("A real machine is homed.");
        Keep(memory => memory.AssumeHomed(profile));
    }

    /// <summary>Processes a position query of the controller.</summary>
    public void Recognise(ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(place);
        lock (_guard) _knowsZero = _path is null || _memory.IsSameZero(place);
        if (place.Doubt.Length > 0) KeepLost(place.Doubt);
        KeepStoppedHard(place, place.StoppedHard);
    }

    /// <summary>Steppers that were stopped without deceleration since the last standstill may have lost steps.</summary>
    /// <param name="place">Current position.</param>
    /// <param name="stoppedHard">Letters of the axes that were stopped like this.</param>
    public void KeepStoppedHard(ControllerPlace place, string stoppedHard)
    {
        if (KnowsZero && Memory.WhyStepsMayBeLost(place, stoppedHard) is { Length: > 0 } why) KeepLost(why);
    }

    /// <summary>Marks the position of a machine with origins or homing as unknown until an origin is set again or the machine is homed.</summary>
    /// <param name="why">For example "the stepper motor of axis A is off".</param>
    public void KeepLost(string why)
    {
        var memory = Memory;
        if (memory.Lost.Length == 0 && (memory.Origins.Count > 0 || memory.HomedAs.Length > 0)) Keep(before => before with { Lost = why });
    }

    /// <summary>Records that the machine is about to move: its position is unknown until it is reported again.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? KeepMoving() => KnowsZero ? Keep(memory => memory with { IsMoving = true }) : null;

    /// <summary>Records a reported position, at rest or moving, regardless of what moved the machine.</summary>
    public void KeepSeen(CountsPoint at, bool moves)
    {
        var memory = Memory;
        if (!KnowsZero || (moves ? memory.IsMoving : !memory.IsMoving && memory.Rest == at)) return;
        Keep(before => before with { IsMoving = moves, Rest = moves ? before.Rest : at });
    }

    /// <summary>Records the end of a motion of this program. If its end is unknown, the zero must be checked again before anything is recorded relative to it;
    /// if nothing was sent, nothing has changed.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? KeepEnd(JobResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var rest = result.IsEndKnown ? result.FinalPosition : null;
        var isUntouched = result.IsEndKnown && rest is null;
        lock (_guard)
        {
            var knew = _knowsZero;
            if (rest is null && !isUntouched) _knowsZero = false;
            return Keep(memory => (!knew ? memory : isUntouched ? memory with { IsMoving = false } : memory with { IsMoving = rest is null, Rest = rest }) with { Lost = result.PositionDoubt.Length > 0 ? result.PositionDoubt : memory.Lost });
        }
    }

    public void Dispose() => _lock?.Dispose();
}

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
    public MachineMemoryDocument Sealed() => this with { Sum = SumOf((this with { Sum = null }).ToJson()) };

    /// <exception cref="JsonException">It is not such a document.</exception>
    /// <exception cref="InvalidDataException">The checksum does not match.</exception>
    public static MachineMemoryDocument Read(string text)
    {
        var document = JsonSerializer.Deserialize(text, MachineMemoryJson.Default.MachineMemoryDocument) ?? throw new JsonException(Wording.Get("Origins.ContainsNull"));
        return document.Sum is null || document.Sum == SumOf(text) ? document : throw new InvalidDataException(Wording.Get("Origins.ChecksumMismatch"));
    }

    public string ToJson() => JsonSerializer.Serialize(this, MachineMemoryJson.Default.MachineMemoryDocument);

    /// <summary>Covers every member except the checksum, also unknown ones; whitespace is ignored.</summary>
    private static string SumOf(string json)
    {
        var members = JsonNode.Parse(json)!.AsObject();
        members.Remove("sum");
        return ContentHash.OfText(members.ToJsonString())[..16];
    }

    public static MachineMemoryDocument From(string machine, MachineMemory memory) => new()
    {
        Machine = machine,
        Active = memory.Active,
        Origins = memory.Origins.ToDictionary(entry => entry.Key, OriginDocument? (entry) => new OriginDocument(entry.Value.X, entry.Value.Y, entry.Value.Z, entry.Value.IsAssumed, ScaleDocument.From(entry.Value.Axes), LettersDocument.From(entry.Value.Axes))),
        Mark = memory.Mark,
        Clock = memory.Clock,
        RestX = memory.Rest?.X,
        RestY = memory.Rest?.Y,
        RestZ = memory.Rest is { Z: not 0 and var height } ? height : null,
        Moving = memory.IsMoving,
        Lost = memory.Lost.Length == 0 ? null : memory.Lost,
        HomedAs = memory.HomedAs.Length == 0 ? null : memory.HomedAs,
        HomedCountsPerMillimetre = ScaleDocument.From(memory.HomedAxes),
    };

    public MachineMemory ToMemory() => new()
    {
        Active = WorkOriginNames.Find(Active) ?? throw new JsonException(Wording.Get("Origins.UnknownOrigin", Active)),
        Origins = ReadOrigins(),
        Mark = Mark,
        Clock = Clock,
        Rest = RestX is { } x && RestY is { } y ? new CountsPoint(x, y, RestZ ?? 0) : null,
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
        public static ScaleDocument? From(KeptAxes axes) => axes == default ? null : new ScaleDocument(axes.X?.Counts, axes.Y?.Counts, axes.Z?.Counts);

        public KeptAxes ToAxes(LettersDocument? letters) => new(Axis(X, letters?.X), Axis(Y, letters?.Y), Axis(Z, letters?.Z));

        private static KeptAxis? Axis(double? counts, char? letter) => counts is { } known ? new KeptAxis(known, letter) : null;
    }

    /// <summary>The controller's letters of the drawing's axes.</summary>
    internal sealed record LettersDocument(char? X, char? Y, char? Z)
    {
        public static LettersDocument? From(KeptAxes axes) =>
            new LettersDocument(axes.X?.Letter, axes.Y?.Letter, axes.Z?.Letter) is var letters && letters == new LettersDocument(null, null, null) ? null : letters;
    }
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, RespectNullableAnnotations = true, UnmappedMemberHandling = JsonUnmappedMemberHandling.Skip)]
[JsonSerializable(typeof(MachineMemoryDocument))]
internal sealed partial class MachineMemoryJson : JsonSerializerContext;

using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>One machine in this host's hands, and what is kept of it. Disposing gives it free.</summary>
public sealed class MachineHold : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string? _path;
    private readonly string _name = "";
    private readonly MachineLock? _lock;
    private MachineMemory _memory = MachineMemory.Empty;

    /// <summary>A machine of which nothing is kept.</summary>
    internal MachineHold()
    {
    }

    /// <exception cref="IOException">The file cannot be read, or holds something else.</exception>
    internal MachineHold(string path, string name, MachineLock taken)
    {
        (_path, _name, _lock) = (path, name, taken);
        try
        {
            if (File.Exists(path)) _memory = (JsonSerializer.Deserialize(File.ReadAllText(path), MachineMemoryJson.Default.MachineMemoryDocument) ?? throw new JsonException(Wording.Get("Origins.HoldsNull"))).ToMemory();
        }
        catch (Exception unusable) when (unusable is JsonException or IOException or UnauthorizedAccessException)
        {
            taken.Dispose(); // the machine is nobody's
            if (unusable is JsonException) throw new InvalidDataException(Wording.Get("Origins.NoRecord", unusable.Message), unusable);
            throw;
        }
    }

    /// <summary>Whether anything is kept beyond this session.</summary>
    public bool IsKept => _path is not null;

    public MachineMemory Memory
    {
        get
        {
            lock (_guard) return _memory;
        }
    }

    /// <summary>Keeps what is known from now on; written whole or not at all.</summary>
    /// <returns>Why it could not be written; null when it was.</returns>
    public string? Keep(Func<MachineMemory, MachineMemory> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            _memory = change(_memory);
            if (_path is null) return null;
            try
            {
                OutputFile.Write(_path, output => output.WriteLine(JsonSerializer.Serialize(MachineMemoryDocument.From(_name, _memory), MachineMemoryJson.Default.MachineMemoryDocument)));
                return null;
            }
            catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
            {
                return failure.Message.TrimEnd('.');
            }
        }
    }

    public void Dispose() => _lock?.Dispose();
}

/// <summary>What is kept of a machine, as it stands in its file: counts of the controller.</summary>
/// <remarks>What the file leaves out has the value written here; an init-only property would be null then.</remarks>
internal sealed record MachineMemoryDocument
{
    public string Machine { get; set; } = "";

    public string Active { get; set; } = WorkOriginNames.First;

    public Dictionary<string, OriginDocument?> Origins { get; set; } = [];

    public int? Mark { get; set; }

    public double? Clock { get; set; }

    public int? RestX { get; set; }

    public int? RestY { get; set; }

    public bool Moving { get; set; }

    public string? Lost { get; set; }

    public static MachineMemoryDocument From(string machine, MachineMemory memory) => new()
    {
        Machine = machine,
        Active = memory.Active,
        Origins = memory.Origins.ToDictionary(entry => entry.Key, OriginDocument? (entry) => new OriginDocument(entry.Value.X, entry.Value.Y, entry.Value.Z, entry.Value.IsAssumed)),
        Mark = memory.Mark,
        Clock = memory.Clock,
        RestX = memory.Rest?.X,
        RestY = memory.Rest?.Y,
        Moving = memory.IsMoving,
        Lost = memory.Lost.Length == 0 ? null : memory.Lost,
    };

    public MachineMemory ToMemory() => new()
    {
        Active = WorkOriginNames.Find(Active) ?? throw new JsonException(Wording.Get("Origins.NoOrigin", Active)),
        Origins = ReadOrigins(),
        Mark = Mark,
        Clock = Clock,
        Rest = RestX is { } x && RestY is { } y ? new CountsPoint(x, y) : null,
        IsMoving = Moving,
        Lost = Lost ?? "",
    };

    private Dictionary<string, WorkOrigin> ReadOrigins()
    {
        var origins = new Dictionary<string, WorkOrigin>();
        foreach (var (key, document) in Origins)
        {
            var name = WorkOriginNames.Find(key) ?? throw new JsonException(Wording.Get("Origins.NoOrigin", key));
            if (document is null) throw new JsonException(Wording.Get("Origins.HoldsNull"));
            if (!origins.TryAdd(name, new WorkOrigin(document.X, document.Y, document.Z) { IsAssumed = document.Assumed })) throw new JsonException(Wording.Get("Origins.Twice", name));
        }

        return origins;
    }

    /// <param name="Assumed">Nobody set it: the controller counted 0 there.</param>
    internal sealed record OriginDocument(int? X, int? Y, int? Z, bool Assumed);
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, RespectNullableAnnotations = true, UnmappedMemberHandling = JsonUnmappedMemberHandling.Skip)]
[JsonSerializable(typeof(MachineMemoryDocument))]
internal sealed partial class MachineMemoryJson : JsonSerializerContext;

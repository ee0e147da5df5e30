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
        catch (JsonException torn)
        {
            taken.Dispose();
            throw new InvalidDataException(Wording.Get("Origins.NoRecord", torn.Message), torn);
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
internal sealed record MachineMemoryDocument
{
    public string Machine { get; init; } = "";

    public string Active { get; init; } = WorkOriginNames.First;

    public Dictionary<string, OriginDocument> Origins { get; init; } = [];

    public int? Mark { get; init; }

    public double? Clock { get; init; }

    public int? RestX { get; init; }

    public int? RestY { get; init; }

    public bool Moving { get; init; }

    public string? Lost { get; init; }

    public static MachineMemoryDocument From(string machine, MachineMemory memory) => new()
    {
        Machine = machine,
        Active = memory.Active,
        Origins = memory.Origins.ToDictionary(entry => entry.Key, entry => new OriginDocument(entry.Value.X, entry.Value.Y, entry.Value.Z, entry.Value.IsAssumed)),
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
        Origins = Origins.ToDictionary(
            entry => WorkOriginNames.Find(entry.Key) ?? throw new JsonException(Wording.Get("Origins.NoOrigin", entry.Key)),
            entry => new WorkOrigin(entry.Value.X, entry.Value.Y, entry.Value.Z) { IsAssumed = entry.Value.Assumed }),
        Mark = Mark,
        Clock = Clock,
        Rest = RestX is { } x && RestY is { } y ? new CountsPoint(x, y) : null,
        IsMoving = Moving,
        Lost = Lost ?? "",
    };

    /// <param name="Assumed">Nobody set it: the controller counted 0 there.</param>
    internal sealed record OriginDocument(int? X, int? Y, int? Z, bool Assumed);
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, UnmappedMemberHandling = JsonUnmappedMemberHandling.Skip)]
[JsonSerializable(typeof(MachineMemoryDocument))]
internal sealed partial class MachineMemoryJson : JsonSerializerContext;

using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Remembers where the last run of each drawing on each controller started. Until there are work origins this is the only thing by which a second run can be told to lie beside the first.</summary>
/// <param name="folder">One small file for each controller and drawing, written whole or not at all; null: kept as long as this object lives, as for a simulated machine.</param>
public sealed class StartMemory(string? folder)
{
    private readonly Lock _guard = new();
    private readonly Dictionary<string, RunStart> _kept = new(StringComparer.Ordinal);

    /// <summary>The folder beside the journals of a folder; null for the operator's data folder.</summary>
    public static string FolderIn(string? journals) => Path.Combine(journals ?? UserFiles.Folder, "starts");

    /// <summary>The last start; null when there was none, or when nobody can read it any more.</summary>
    public RunStart? Last(string controller, string drawing)
    {
        var key = KeyOf(controller, drawing);
        lock (_guard)
        {
            if (folder is null) return _kept.GetValueOrDefault(key);
        }

        try
        {
            return JsonSerializer.Deserialize(File.ReadAllText(Path.Combine(folder, key)), RunStartJson.Default.RunStart);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or JsonException)
        {
            return null;
        }
    }

    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be written.</exception>
    public void Remember(RunStart start)
    {
        ArgumentNullException.ThrowIfNull(start);
        var key = KeyOf(start.Controller, start.Drawing);
        lock (_guard)
        {
            _kept[key] = start;
            if (folder is null) return;
            Directory.CreateDirectory(folder);
            OutputFile.Write(Path.Combine(folder, key), output => output.WriteLine(JsonSerializer.Serialize(start, RunStartJson.Default.RunStart)));
        }
    }

    /// <summary>A file is the same from whatever folder it is named.</summary>
    private static string KeyOf(string controller, string drawing) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes($"{controller}\n{drawing}")))[..32] + ".json";
}

/// <summary>Where the last run of a drawing on a controller had the drawing's zero.</summary>
/// <param name="Controller">Where the controller is reached.</param>
/// <param name="Drawing">Its file, with the whole path.</param>
/// <param name="FrameX">Controller counts of axis A at the drawing's zero.</param>
/// <param name="FrameY">The same of axis B.</param>
/// <param name="At">When that run began.</param>
public sealed record RunStart(string Controller, string Drawing, int FrameX, int FrameY, DateTimeOffset At);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase)]
[JsonSerializable(typeof(RunStart))]
internal sealed partial class RunStartJson : JsonSerializerContext;

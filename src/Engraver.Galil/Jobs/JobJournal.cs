using System.Text.Json;
using System.Text.Json.Serialization;

namespace Engraver.Galil.Jobs;

/// <summary>The journal file: one JSON object a line, each flushed to the file before the job goes on, so that a crash leaves every line but the last readable.</summary>
internal sealed class JobJournal : IDisposable
{
    /// <summary>Generated at build time: reflection on first use would hold up the heartbeat.</summary>
    private static readonly JsonSerializerOptions Json = new(JsonSerializerDefaults.Web)
    {
        Converters = { new JsonStringEnumConverter<JobMode>(JsonNamingPolicy.CamelCase), new JsonStringEnumConverter<JobOutcome>(JsonNamingPolicy.CamelCase) },
        TypeInfoResolver = JournalJson.Default,
    };

    private readonly StreamWriter? _file;

    /// <param name="path">Appended to; null for no journal.</param>
    public JobJournal(string? path) => _file = path is null ? null : new StreamWriter(path, append: true) { AutoFlush = true, NewLine = "\n" };

    /// <summary>The lines of a journal, also of one that is being written.</summary>
    public static IEnumerable<string> ReadLines(string path)
    {
        using var file = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        while (file.ReadLine() is { } line) yield return line;
    }

    public static T? Read<T>(string line) => JsonSerializer.Deserialize<T>(line, Json);

    public void Write<T>(T line) => _file?.WriteLine(JsonSerializer.Serialize(line, Json));

    /// <summary>Each line was flushed as it was written: what the disk refuses now, it has refused before, and the job has said so.</summary>
    public void Dispose()
    {
        try
        {
            _file?.Dispose();
        }
        catch (IOException)
        {
        }
    }
}

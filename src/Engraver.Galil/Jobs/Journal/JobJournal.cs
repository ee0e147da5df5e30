using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>The journal file: one JSON object per line with a running number and a check sum (<see cref="JournalSeal"/>), each flushed to the file before
/// the job continues, so that a crash leaves every line but the last readable.</summary>
internal sealed class JobJournal : IDisposable
{
    /// <summary>Generated at build time: reflection at the first use would delay the heartbeat.</summary>
    private static readonly JsonSerializerOptions Json = new(JsonSerializerDefaults.Web)
    {
        Converters = { new JsonStringEnumConverter<JobMode>(JsonNamingPolicy.CamelCase), new JsonStringEnumConverter<JobOutcome>(JsonNamingPolicy.CamelCase), new JsonStringEnumConverter<JobPhase>(JsonNamingPolicy.CamelCase) },
        TypeInfoResolver = JournalJson.Default,
    };

    private readonly StreamWriter? _file;
    private long _number;
    private (long Length, long Number) _start;
    private (long Length, long Number) _kept;

    /// <param name="path">Appended to; null for no journal.</param>
    public JobJournal(string? path)
    {
        if (path is null) return;
        var isTorn = IsReadable(path) && Continue(path);
        _file = Over(new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.Read, bufferSize: 0));
        if (isTorn) _file.WriteLine();
    }

    /// <param name="file">Appended to, and owned.</param>
    internal JobJournal(Stream file) => _file = Over(file);

    private static StreamWriter Over(Stream file)
    {
        if (file.CanSeek) file.Seek(0, SeekOrigin.End);
        return new StreamWriter(file) { AutoFlush = true, NewLine = "\n" };
    }

    /// <summary>The journal was given up while its job continues: nothing more is written.</summary>
    public bool IsGivenUp { get; private set; }

    /// <summary>The lines of a job begin here.</summary>
    public void BeginJob() => _start = Now;

    /// <summary>What was written so far stays in a journal that is given up.</summary>
    public void Keep() => _kept = Now;

    /// <summary>The journal can no longer be written (a full disk), and its job continues: the last place that it states would soon be wrong. Replaces
    /// everything after <see cref="Keep"/> by a line that states this, which needs no more room on the disk. Where even that fails the job is removed from
    /// the journal.</summary>
    public void GiveUp(string reason)
    {
        IsGivenUp = true;
        if (_file?.BaseStream is not { CanSeek: true } file) return; // a pipe: what was written was read
        try
        {
            _number = _kept.Number;
            file.Seek(_kept.Length, SeekOrigin.Begin);
            file.Write(Encoding.UTF8.GetBytes(Sealed(new JournalGivenUp(reason)) + "\n"));
            file.SetLength(file.Position);
        }
        catch (IOException)
        {
            CutBack(file);
        }
    }

    private void CutBack(Stream file)
    {
        try
        {
            file.SetLength(_start.Length);
            file.Seek(0, SeekOrigin.End);
        }
        catch (IOException)
        {
            // The medium cannot be written at all: the journal remains as it is.
        }
    }

    private (long Length, long Number) Now => (_file?.BaseStream is { CanSeek: true } file ? file.Length : 0, _number);

    /// <summary>False for a pipe: it cannot be read again, and opening it would wait forever. Like an empty file it has no length.</summary>
    public static bool IsReadable(string journal)
    {
        var named = new FileInfo(journal);
        var file = named.LinkTarget is null ? named : named.ResolveLinkTarget(returnFinalTarget: true) as FileInfo; // the length of a link is that of its name
        return file is { Exists: true, Length: > 0 };
    }

    /// <summary>Continues the running number of the present lines.</summary>
    /// <returns>Whether the last one is half a line.</returns>
    private bool Continue(string path)
    {
        foreach (var line in ReadLines(path)) _number = JournalSeal.Of(line)?.Number ?? _number;
        using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        file.Seek(-1, SeekOrigin.End);
        return file.ReadByte() != '\n';
    }

    /// <summary>The lines of a journal, also of one that is being written.</summary>
    public static IEnumerable<string> ReadLines(string path)
    {
        using var file = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        while (file.ReadLine() is { } line) yield return line;
    }

    public static T? Read<T>(string line) => JsonSerializer.Deserialize<T>(line, Json);

    /// <exception cref="IOException">It cannot be written.</exception>
    public void Write<T>(T line)
    {
        if (!IsGivenUp) _file?.WriteLine(Sealed(line));
    }

    /// <summary>The last line of a job; where the journal was given up it is written if there is room again.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    public void Write(JournalEnd end)
    {
        try
        {
            _file?.WriteLine(Sealed(end));
        }
        catch (IOException) when (IsGivenUp)
        {
            // This was reported when the journal was given up.
        }
    }

    private string Sealed<T>(T line) => JournalSeal.Put(JsonSerializer.Serialize(line, Json), ++_number);

    /// <summary>Every line was flushed when it was written, so an error of the disk now was there before and has been reported.</summary>
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

/// <summary>The lines of the journal.</summary>
[JsonSourceGenerationOptions(GenerationMode = JsonSourceGenerationMode.Metadata)]
[JsonSerializable(typeof(JournalHeader))]
[JsonSerializable(typeof(JournalProgress))]
[JsonSerializable(typeof(JournalEnd))]
[JsonSerializable(typeof(JournalFound))]
[JsonSerializable(typeof(JournalGivenBack))]
[JsonSerializable(typeof(JournalResumed))]
[JsonSerializable(typeof(JournalGivenUp))]
[JsonSerializable(typeof(JournalControl))]
[JsonSerializable(typeof(JournalOpened))]
internal sealed partial class JournalJson : JsonSerializerContext;

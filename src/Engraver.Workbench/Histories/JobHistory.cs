using System.Globalization;
using System.Text.Json;
using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Histories;

/// <summary>The index of all runs and posted programs: a folder with one file for each, so that several processes can write at the same time and files are
/// complete. The oldest entries are deleted when there are too many.</summary>
/// <remarks>Any thread.</remarks>
public sealed class JobHistory
{
    /// <summary>Maximum number of entries.</summary>
    public const int MaxEntries = 1000;

    private const string FileExtension = ".json";

    /// <summary>Subfolder for invalid files.</summary>
    private const string UnreadableFolder = "unreadable";

    private readonly Lock _guard = new();
    private readonly string? _folder;
    private readonly int _maxEntries;
    private readonly List<HistoryEntry> _unsaved = [];

    /// <param name="folder">Null: the history exists only in memory.</param>
    /// <param name="maxEntries">Maximum number of entries.</param>
    public JobHistory(string? folder, int maxEntries = MaxEntries) => (_folder, _maxEntries) = (folder, maxEntries);

    /// <summary>Raised after <see cref="Snapshot"/> has changed, on the thread that changed it.</summary>
    public event EventHandler? Changed;

    /// <summary>The entries of the last reading, plus those added by this process since.</summary>
    public HistorySnapshot Snapshot { get; private set; } = new([], []);

    /// <summary>The folder beside the journals of a folder; null for the operator's data folder.</summary>
    public static string FolderIn(string? journals) => Path.Combine(journals ?? UserFiles.Folder, "history");

    /// <summary>Adds an entry and deletes the oldest ones when there are too many.</summary>
    /// <returns>The entry with its name, and why it could not be written, without a full stop; null on success.</returns>
    public (HistoryEntry Entry, string? Failure) Add(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        var named = entry with { Id = string.Create(CultureInfo.InvariantCulture, $"{entry.Date.UtcDateTime:yyyyMMdd-HHmmss-fff}-{Guid.NewGuid().ToString("N")[..6]}") };
        return (named, Save(named));
    }

    /// <summary>Rewrites an entry, for example after a report was created.</summary>
    /// <returns>As for <see cref="Add"/>.</returns>
    public string? Save(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        var failure = Write(entry);
        lock (_guard)
        {
            if (_folder is null) Insert(_unsaved, entry);
            var entries = Snapshot.Entries.ToList();
            Insert(entries, entry);
            Snapshot = Snapshot with { Entries = entries };
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return failure;
    }

    /// <summary>Stores the read-back result in the entry of a program; does nothing if the program has no entry.</summary>
    /// <param name="program">Path of the program.</param>
    /// <returns>As for <see cref="Add"/>.</returns>
    public string? NoteReadBack(string program, HistoryReadBack found)
    {
        ArgumentNullException.ThrowIfNull(program);
        var path = Path.GetFullPath(program);
        return Refresh().Entries.FirstOrDefault(entry => entry.Program == path) is { } entry ? Save(entry with { ReadBack = found }) : null;
    }

    /// <summary>Removes an entry.</summary>
    /// <returns>Why that failed, without a full stop; null on success.</returns>
    public string? Remove(HistoryEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        var failure = DeleteFile(entry);
        lock (_guard)
        {
            _unsaved.RemoveAll(known => known.Id == entry.Id);
            Snapshot = Snapshot with { Entries = [.. Snapshot.Entries.Where(known => known.Id != entry.Id)] };
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return failure;
    }

    /// <summary>Reads the index. Invalid files are moved to a subfolder and reported; entries of a later version are skipped.</summary>
    public HistorySnapshot Refresh()
    {
        var (entries, findings) = (new List<HistoryEntry>(), new List<string>());
        foreach (var file in Readable(findings))
        {
            if (Read(file, findings) is { } entry) entries.Add(entry);
        }

        lock (_guard)
        {
            entries.AddRange(_unsaved);
            Snapshot = new HistorySnapshot([.. entries.OrderByDescending(entry => entry.Date).ThenByDescending(entry => entry.Id, StringComparer.Ordinal)], findings);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return Snapshot;
    }

    private static void Insert(List<HistoryEntry> entries, HistoryEntry entry)
    {
        var at = entries.FindIndex(known => known.Id == entry.Id);
        if (at >= 0) entries[at] = entry;
        else entries.Insert(0, entry);
    }

    private string? Write(HistoryEntry entry)
    {
        if (_folder is null) return null;
        try
        {
            Directory.CreateDirectory(_folder);
            OutputFile.Write(PathOf(entry.Id), output => output.WriteLine(JsonSerializer.Serialize(entry, HistoryJsonContext.Default.HistoryEntry)));
            foreach (var old in Files().SkipLast(_maxEntries)) File.Delete(old);
            return null;
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return SystemErrorText.FromException(unwritable);
        }
    }

    private string? DeleteFile(HistoryEntry entry)
    {
        if (_folder is null || !Directory.Exists(_folder)) return null;
        try
        {
            File.Delete(PathOf(entry.Id));
            return null;
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            return SystemErrorText.FromException(stuck);
        }
    }

    private IReadOnlyList<string> Readable(List<string> findings)
    {
        try
        {
            return [.. Files()];
        }
        catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
        {
            findings.Add(Wording.Get("History.Unreadable", _folder, SystemErrorText.FromException(closed)));
            return [];
        }
    }

    private HistoryEntry? Read(string file, List<string> findings)
    {
        try
        {
            var text = File.ReadAllText(file);
            var version = (JsonSerializer.Deserialize(text, HistoryJsonContext.Default.HistoryVersion) ?? throw new JsonException(Wording.Get("History.ContainsNull"))).Version;
            if (version <= HistoryEntry.CurrentVersion)
            {
                var entry = JsonSerializer.Deserialize(text, HistoryJsonContext.Default.HistoryEntry)!;
                return entry.Drawing.Length > 0 ? entry with { Id = Path.GetFileNameWithoutExtension(file) } : throw new JsonException(Wording.Get("History.NoDrawing"));
            }

            findings.Add(Wording.Get("History.OtherVersion", file, version));
        }
        catch (FileNotFoundException)
        {
            // Another process has deleted it.
        }
        catch (JsonException broken)
        {
            findings.Add(MoveAside(file, SystemErrorText.FromException(broken)));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            findings.Add(Wording.Get("History.Unreadable", file, SystemErrorText.FromException(unreadable)));
        }

        return null;
    }

    private string MoveAside(string file, string why)
    {
        var aside = Path.Combine(_folder!, UnreadableFolder, Path.GetFileName(file));
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(aside)!);
            File.Move(file, aside, overwrite: true);
            return Wording.Get("History.SetAside", file, why, aside);
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            return Wording.Get("History.Unreadable", file, SystemErrorText.FromException(stuck));
        }
    }

    /// <summary>The oldest first: names start with the date.</summary>
    private IEnumerable<string> Files() => _folder is not null && Directory.Exists(_folder) ? Directory.EnumerateFiles(_folder, "*" + FileExtension).Where(file => !FileKind.IsStream(file)).Order(StringComparer.Ordinal) : [];

    private string PathOf(string id) => Path.Combine(_folder!, id + FileExtension);
}

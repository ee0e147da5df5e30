using System.Text;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The file of the counter book: read at any time, changed by one process at a time, replaced as a whole.</summary>
internal sealed class CounterFile(string path, TimeProvider time)
{
    private const string LockSuffix = ".lock";
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(20);
    private static readonly TimeSpan s_limit = TimeSpan.FromSeconds(5);

    /// <summary>A missing file has no counters.</summary>
    /// <exception cref="CounterException">The file cannot be read, or is damaged.</exception>
    public CounterDocument Read()
    {
        try
        {
            return File.Exists(path) ? CounterDocument.Read(File.ReadAllText(path)) : new CounterDocument();
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or JsonException or InvalidDataException)
        {
            throw new CounterException(SerialRules.CountersUnreadable.At(default, path, unreadable is JsonException ? Wording.Get("Counters.NotACounterFile") : SystemErrorText.FromException(unreadable)));
        }
    }

    /// <summary>Changes the content. It is on the disk when this returns.</summary>
    /// <exception cref="CounterException">The file cannot be read or written, is damaged, or <paramref name="change"/> refused.</exception>
    public async Task ChangeAsync(Func<CounterDocument, CounterDocument> change, CancellationToken cancellation)
    {
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            using var held = await LockAsync(cancellation).ConfigureAwait(false);
            var text = change(Read()).ToJson();
            OutputFile.WriteBytes(path, stream =>
            {
                stream.Write(Encoding.UTF8.GetBytes(text));
                (stream as FileStream)?.Flush(flushToDisk: true);
            });
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new CounterException(SerialRules.CountersNotWritten.At(default, path, SystemErrorText.FromException(unwritable)));
        }
    }

    private async Task<FileStream> LockAsync(CancellationToken cancellation)
    {
        for (var start = time.GetTimestamp(); ; await Task.Delay(s_interval, time, cancellation).ConfigureAwait(false))
        {
            try
            {
                return new FileStream(path + LockSuffix, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
            }
            catch (IOException) when (File.Exists(path + LockSuffix) && time.GetElapsedTime(start) < s_limit)
            {
                // Another process holds it for the time of one change.
            }
        }
    }
}

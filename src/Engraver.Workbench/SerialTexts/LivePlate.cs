namespace Engraver.Workbench.SerialTexts;

/// <summary>The sign that a process is engraving a plate: a file opened without sharing. The system releases it when the process ends, however it
/// ends.</summary>
internal sealed class LivePlate : IDisposable
{
    private readonly FileStream _file;

    private LivePlate(FileStream file) => _file = file;

    /// <param name="book">Path of the counter book.</param>
    /// <param name="plate">Its id.</param>
    /// <exception cref="CounterException">The folder cannot be written.</exception>
    public static LivePlate Hold(string book, string plate)
    {
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(book)!);
            return new LivePlate(new FileStream(PathOf(book, plate), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, bufferSize: 1, FileOptions.DeleteOnClose));
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new CounterException(Core.Diagnostics.SerialRules.CountersNotWritten.At(default, book, Core.Languages.SystemErrorText.FromException(unwritable)));
        }
    }

    /// <summary>False if its process has ended; the file that a killed process left is deleted.</summary>
    public static bool IsHeld(string book, string plate)
    {
        var path = PathOf(book, plate);
        if (!File.Exists(path)) return false;
        try
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.None, bufferSize: 1, FileOptions.DeleteOnClose);
            return false;
        }
        catch (FileNotFoundException)
        {
            return false;
        }
        catch (Exception held) when (held is IOException or UnauthorizedAccessException)
        {
            return true;
        }
    }

    public void Dispose() => _file.Dispose();

    private static string PathOf(string book, string plate) => $"{book}.{plate}.live";
}

using System.Globalization;

namespace Engraver.Workbench.Reports;

/// <summary>Reports of failures of the program itself, written to files for its developers. Any thread.</summary>
/// <param name="folder">Where they are kept; made when it is missing.</param>
public sealed class FailureReports(string folder, TimeProvider time)
{
    /// <summary>Most reports of one session, so that a repeated failure does not fill the disk.</summary>
    private const int MostReports = 20;

    private int _reports;

    public string Folder => folder;

    /// <returns>The file; null when none could be written, or too many were.</returns>
    public string? Write(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        var number = Interlocked.Increment(ref _reports);
        if (number > MostReports) return null;
        var now = time.GetUtcNow();
        var file = Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"crash-{now:yyyyMMdd-HHmmss}-{number}.txt"));
        try
        {
            Directory.CreateDirectory(folder);
            File.WriteAllText(file, string.Create(CultureInfo.InvariantCulture, $"{now:O}\n{typeof(FailureReports).Assembly.GetName()}\n{Environment.OSVersion}, .NET {Environment.Version}\n\n{failure}\n"));
            return file;
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return null; // the alarm names the failure without a report too
        }
    }
}

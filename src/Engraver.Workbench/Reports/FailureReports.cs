using System.Globalization;

namespace Engraver.Workbench.Reports;

/// <summary>Writes reports of internal errors to files for the developers. Any thread.</summary>
/// <param name="folder">Folder of the reports; created if missing.</param>
public sealed class FailureReports(string folder, TimeProvider time)
{
    /// <summary>Maximum number of reports of one session, so that a repeated failure does not fill the disk.</summary>
    private const int MaxReports = 20;

    private int _reports;

    public string Folder => folder;

    /// <returns>The file; null if it could not be written or there are too many.</returns>
    public string? Write(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        var number = Interlocked.Increment(ref _reports);
        if (number > MaxReports) return null;
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
            return null; // The alarm states the error also without a report.
        }
    }
}

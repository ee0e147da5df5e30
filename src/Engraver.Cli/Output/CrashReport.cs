using System.Globalization;

namespace Engraver.Cli.Output;

/// <summary>Reports an internal error: writes a file with the details, and returns one sentence that names the file.</summary>
internal static class CrashReport
{
    public static string Write(Exception bug, string[] args)
    {
        var name = string.Create(CultureInfo.InvariantCulture, $"engraver-crash-{DateTime.UtcNow:yyyyMMdd-HHmmss}-{Environment.ProcessId}.txt");
        var path = Path.Combine(Path.GetTempPath(), name);
        var report = $"engraver {typeof(CrashReport).Assembly.GetName().Version}\narguments: {string.Join(' ', args)}\nsystem: {Environment.OSVersion}, .NET {Environment.Version}\n\n{bug}\n";
        try
        {
            File.WriteAllText(path, report);
            return Wording.Get("CrashReport.Written", bug.GetType().Name, bug.Message, path);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return Wording.Get("CrashReport.NotWritten", bug.GetType().Name, bug.Message, unwritable.Message);
        }
    }
}

using System.Globalization;

namespace Engraver.Cli.Output;

/// <summary>What is left of a bug of ours: a file with everything needed to find it, and one sentence that names the file.</summary>
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
            return $"internal error ({bug.GetType().Name}: {bug.Message}). A crash report stands in {path}; please send it with the drawing.";
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return $"internal error ({bug.GetType().Name}: {bug.Message}), and no crash report could be written: {unwritable.Message}";
        }
    }
}

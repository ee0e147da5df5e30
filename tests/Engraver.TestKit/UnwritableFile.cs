using System.Diagnostics;

namespace Engraver.TestKit;

/// <summary>A file that can be read but not written, as on a read-only medium, also by the superuser, to whom permissions do not apply: on Linux the executable
/// file of a running process.</summary>
public sealed class UnwritableFile : IDisposable
{
    private readonly Process? _process;

    /// <param name="path">Must not exist.</param>
    /// <param name="lines">Its last lines; the content before them is not text.</param>
    public UnwritableFile(string path, IEnumerable<string> lines)
    {
        Path = path;
        if (OperatingSystem.IsWindows())
        {
            File.WriteAllLines(path, lines);
            File.SetAttributes(path, FileAttributes.ReadOnly);
            return;
        }

        File.Copy("/bin/sleep", path); // the loader ignores bytes after a program
        File.AppendAllLines(path, lines.Prepend(""));
        _process = Process.Start(path, "600");
    }

    public string Path { get; }

    public void Dispose()
    {
        _process?.Kill();
        _process?.WaitForExit();
        _process?.Dispose();
        if (OperatingSystem.IsWindows()) File.SetAttributes(Path, FileAttributes.Normal);
    }
}

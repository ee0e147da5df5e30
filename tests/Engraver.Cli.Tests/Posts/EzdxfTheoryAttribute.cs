using System.Diagnostics;

namespace Engraver.Cli.Tests.Posts;

/// <summary>A test that uses ezdxf (Debian: python3-ezdxf), which shares no code with this program; skipped if it is not installed. ./test installs it if
/// permitted.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class EzdxfTheoryAttribute : TheoryAttribute
{
    /// <summary>Debian's own interpreter: other interpreters on the path do not find Debian's packages.</summary>
    public const string Python = "/usr/bin/python3";

    private static readonly Lazy<bool> s_installed = new(IsInstalled);

    public EzdxfTheoryAttribute()
    {
        if (!s_installed.Value) Skip = "python3-ezdxf is not installed.";
    }

    private static bool IsInstalled()
    {
        if (!File.Exists(Python)) return false;
        using var process = Process.Start(new ProcessStartInfo(Python, ["-c", "import ezdxf"]) { RedirectStandardError = true });
        process!.StandardError.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode == 0;
    }
}

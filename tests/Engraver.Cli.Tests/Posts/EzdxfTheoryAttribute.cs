using System.Diagnostics;

namespace Engraver.Cli.Tests.Posts;

/// <summary>A test that asks ezdxf (Debian: python3-ezdxf), which shares no code with us; skipped where it is not installed. ./test installs it when it
/// may.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class EzdxfTheoryAttribute : TheoryAttribute
{
    /// <summary>Debian's own interpreter: another one on the path does not see Debian's packages.</summary>
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

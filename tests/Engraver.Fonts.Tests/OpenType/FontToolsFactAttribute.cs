using System.Diagnostics;

namespace Engraver.Fonts.Tests.OpenType;

/// <summary>A test that compares a font with fontTools (Debian: python3-fonttools), which shares no code with this program; skipped if it or the font is not
/// installed. ./test installs them if permitted.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class FontToolsFactAttribute : FactAttribute
{
    /// <summary>Debian's own interpreter: other interpreters on the path do not find Debian's packages.</summary>
    public const string Python = "/usr/bin/python3";

    private static readonly Lazy<bool> s_installed = new(IsInstalled);

    public FontToolsFactAttribute(string font)
    {
        if (!s_installed.Value) Skip = "python3-fonttools is not installed.";
        else if (!File.Exists(font)) Skip = $"{font} is not installed (tests/prerequisites names the packages).";
    }

    private static bool IsInstalled()
    {
        if (!File.Exists(Python)) return false;
        using var process = Process.Start(new ProcessStartInfo(Python, ["-c", "import fontTools"]) { RedirectStandardError = true });
        process!.StandardError.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode == 0;
    }
}

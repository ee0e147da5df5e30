using Xunit;

namespace Engraver.TestKit;

/// <summary>A test that uses DejaVu Sans (Debian: fonts-dejavu-core); skipped if it is not installed. ./test installs it if permitted.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class InstalledFontFactAttribute : FactAttribute
{
    public const string TrueType = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

    public InstalledFontFactAttribute()
    {
        if (!File.Exists(TrueType)) Skip = "fonts-dejavu-core is not installed.";
    }
}

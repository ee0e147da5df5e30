namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>A test that needs installed fonts of these families.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class FontFactAttribute : FactAttribute
{
    public FontFactAttribute(params string[] families)
    {
        var missing = families.Where(family => InstalledFont.TryFind(family) is null).ToList();
        if (missing.Count > 0) Skip = $"Fonts not installed: {string.Join(", ", missing)} (tests/prerequisites names the packages).";
    }
}

namespace Engraver.Shaping.Tests;

/// <summary>A test that needs the conformance file of Unicode; skipped where it is not installed.</summary>
public sealed class ConformanceFactAttribute : FactAttribute
{
    public ConformanceFactAttribute()
    {
        if (!File.Exists(BidiLineTests.ConformanceFile)) Skip = "BidiTest.txt is not installed.";
    }
}

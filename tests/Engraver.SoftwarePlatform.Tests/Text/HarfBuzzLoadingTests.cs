using Engraver.SoftwarePlatform.Tests.X11;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>The library is loaded with the first text that needs it, and text is shown without it too. Each test is a process of its own.</summary>
public class HarfBuzzLoadingTests
{
    [Theory]
    [InlineData("Feed 12.5 mm/s at X e\u0301 \u03B1\u0436\u4E2D", false)]
    [InlineData("\u0628\u0628", true)]
    public void The_library_is_loaded_only_for_scripts_that_need_it(string text, bool isLoaded)
    {
        using var program = Start(ShapingProgram.Argument, text);

        Assert.Equal($"assembly {isLoaded} library {isLoaded}", program.WaitFor("assembly"));
        Assert.Equal(0, program.WaitForExit());
    }

    [Fact]
    public void Without_the_library_letters_are_shown_one_by_one()
    {
        using var program = Start(ShapingProgram.Argument, "\u05D0\u05D1", ShapingProgram.WithoutLibrary);

        Assert.Equal("clusters 1 0", program.WaitFor("clusters"));
        Assert.Equal(0, program.WaitForExit());
    }

    private static LineProcess Start(params string[] arguments) => new("dotnet", null, [typeof(HarfBuzzLoadingTests).Assembly.Location, .. arguments]);
}

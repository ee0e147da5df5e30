using Engraver.App.Sessions;

namespace Engraver.App.Tests.Sessions;

public sealed class DesktopOptionsTests
{
    [Fact]
    public void The_words_of_the_contract_are_read()
    {
        var (options, wrong) = DesktopOptions.Parse(["plate.dxf", "--script", "a.scr", "--headless", "--screenshot", "out.png", "--size", "1280x800", "--scale", "1.5"]);

        Assert.Null(wrong);
        Assert.Equal(new DesktopOptions { File = "plate.dxf", Script = "a.scr", Headless = true, Screenshot = "out.png", Size = (1280, 800), Scale = 1.5 }, options);
    }

    [Theory]
    [InlineData("--size", "1280")]
    [InlineData("--size", "1280x")]
    [InlineData("--size", "10x10")]
    [InlineData("--scale", "1,5")]
    [InlineData("--scale", "9")]
    [InlineData("--unheard", "of")]
    [InlineData("--script")]
    [InlineData("a.dxf", "b.dxf")]
    public void What_is_not_understood_is_said(params string[] words)
    {
        var (options, wrong) = DesktopOptions.Parse(words);

        Assert.Null(options);
        Assert.Contains(words[^1], wrong, StringComparison.Ordinal);
    }
}

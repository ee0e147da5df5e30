using Engraver.Galil.Protocol;

namespace Engraver.Galil.Tests.Protocol;

public class ControllerNumberTests
{
    [Theory]
    [InlineData(" 200, -10, 0, -110", new[] { 200.0, -10, 0, -110 })]
    [InlineData("0000000012,-0000000003", new[] { 12.0, -3 })]
    [InlineData(" 0.0000 1.5000", new[] { 0.0, 1.5 })]
    [InlineData("19456", new[] { 19456.0 })]
    [InlineData("$FFFFFFFF.8000", new[] { -0.5 })]
    [InlineData(" 20000.0000-81.0000", new[] { 20000.0, -81 })]
    [InlineData("-1.0000-2.5000 3.0000-4.0000", new[] { -1.0, -2.5, 3, -4 })]
    public void Numbers_are_read_however_the_controller_spaces_them(string data, double[] expected)
    {
        Assert.True(ControllerNumber.TryParseAll(data, out var values));
        Assert.Equal(expected, values);
    }

    [Theory]
    [InlineData("HTTP/1.1")]
    [InlineData("1.0 x")]
    [InlineData("$GG")]
    [InlineData("1e5")]
    [InlineData("1.0--2.0")]
    [InlineData("1.0-")]
    [InlineData("1.0+2.0")]
    [InlineData("1.0.5-2")]
    public void Other_text_is_no_number(string data) => Assert.False(ControllerNumber.TryParseAll(data, out _));
}

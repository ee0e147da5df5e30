using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>Object snaps typed at a point prompt, OSNAP's list and the switches of polar tracking.</summary>
public class SnapOverrideTests
{
    [Theory]
    [InlineData("per", 128)]
    [InlineData("_tan", 256)]
    [InlineData("nearest", 512)]
    [InlineData("MID", 2)]
    [InlineData("nod", 8)]
    [InlineData("non", 0)]
    public async Task A_typed_snap_holds_for_one_place(string typed, int bits)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("DIST", "0,0");
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync(typed));
        Assert.Equal(bits, talk.Session.View.Current.OneTimeSnap);
        await talk.TypeAsync("3,4");

        Assert.Null(talk.Session.View.Current.OneTimeSnap);
        Assert.Contains("5", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Esc_forgets_it_and_where_no_place_is_asked_for_it_is_an_answer()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("DIST", "end");
        await talk.Session.CancelAsync();
        Assert.Null(talk.Session.View.Current.OneTimeSnap);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("CNCFEED", "end"));
        Assert.Null(talk.Session.View.Current.OneTimeSnap);
    }

    [Fact]
    public async Task Osnap_knows_them_by_name()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("OSNAP", "PER,tan nea,endpoint");
        Assert.Equal(1 + 128 + 256 + 512, talk.Session.View.Current.ObjectSnapModes);
        await talk.TypeAsync("OSNAP", "none");
        Assert.Equal(0, talk.Session.View.Current.ObjectSnapModes);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OSNAP", "MI"));
    }

    [Fact]
    public async Task Ortho_and_polar_are_never_on_together()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("ORTHO", "ON", "POLAR", "ON", "POLARANG", "22.5");
        Assert.Equal((false, true, 22.5), (talk.Session.View.Current.Ortho, talk.Session.View.Current.Polar, talk.Session.View.Current.PolarAngle));
        await talk.TypeAsync("ORTHOMODE", "1");
        Assert.Equal((true, false), (talk.Session.View.Current.Ortho, talk.Session.View.Current.Polar));
        await talk.TypeAsync("POLAR", "ON", "ORTHO", "ON");
        Assert.Equal((true, false), (talk.Session.View.Current.Ortho, talk.Session.View.Current.Polar));
        Assert.Equal(0.0, talk.Session.Settings.Current.Variables["POLARTRACK"]);
    }
}

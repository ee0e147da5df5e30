using Engraver.Core.Kerf;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

public class KerfCommandTests
{
    [Fact]
    public async Task Side_and_diameter_are_kept_undone_and_switched_off()
    {
        await using var talk = CommandTalk.WithDrawing();
        await talk.TypeAsync("KERF", "N", "3.5");
        Assert.Equal((KerfSide.Nesting, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        await talk.TypeAsync("KERF", "OFF");
        Assert.Equal((KerfSide.Off, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        await talk.TypeAsync("U");
        Assert.Equal(KerfSide.Nesting, talk.State.Settings.Kerf);
        await talk.TypeAsync("KERF", "I", "");
        Assert.Equal((KerfSide.Inside, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        Assert.IsNotType<InputResult.Failed>(await talk.TypeAsync("KERF", "L", "2"));
        Assert.Equal((KerfSide.Left, 2.0), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
    }
}

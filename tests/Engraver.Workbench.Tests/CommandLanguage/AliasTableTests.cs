using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Tests.CommandLanguage;

public class AliasTableTests
{
    [Fact]
    public void Lines_of_a_PGP_file_are_read_and_the_last_one_wins()
    {
        var table = AliasTable.Empty
            .With("; built in\nM, *MOVE ; comment\nE,*ERASE\nDIR, DIR, 8,File specification: ,\n", (_, _) => true)
            .With("m, *mirror\nnonsense\n,*X\nX,*\n", (_, _) => true);

        Assert.Equal(("MIRROR", "ERASE", null), (table.CommandOf("M"), table.CommandOf("e"), table.CommandOf("DIR")));
        Assert.Equal(2, table.Commands.Count);
        Assert.Empty(table.Findings);
    }

    [Fact]
    public void A_line_that_is_not_allowed_is_named()
    {
        var table = AliasTable.Empty.With("\nR, *CNCRUN", (alias, _) => alias.Length > 2);

        Assert.Contains("line 2: the alias R is too short for ", Assert.Single(table.Findings), StringComparison.Ordinal);
        Assert.Null(table.CommandOf("R"));
    }
}

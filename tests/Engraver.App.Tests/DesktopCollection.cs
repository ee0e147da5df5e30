namespace Engraver.App.Tests;

/// <summary>Tests that share the one application run one after the other.</summary>
[CollectionDefinition(Name)]
public sealed class DesktopCollection : ICollectionFixture<DesktopFixture>
{
    public const string Name = "The operator desktop";
}

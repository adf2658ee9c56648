// SPDX-License-Identifier: AGPL-3.0-or-later
// Pages of one process and their way from another.
#include "actors/pages/page_store.hpp"

#include <random>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "tests/states/far_store.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {
namespace {

page_ptr page_of(unsigned seed, std::size_t size = max_page_bytes) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i)
    bytes[i] = static_cast<std::byte>(seed + i / 251);
  return page::from_bytes(bytes);
}

/// Another node, which sends when a test says so.
struct remote_state {
  struct question {
    hash_list ids;
    bool packed = false;
    caf::typed_response_promise<page_batch> promise;
  };
  std::deque<question> asked;
  static inline const char* name = "remote";
};

caf::behavior remote_node(caf::stateful_actor<remote_state>* self, int /*number*/) {
  return {[=](get_atom, const hash_list& ids, bool packed) {
            auto promise = self->make_response_promise<page_batch>();
            self->state.asked.push_back({ids, packed, promise});
            return promise;
          },
          [](const doing& that) { that.what(); }};
}

class PageStore : public States {
protected:
  PageStore() {
    for (unsigned i = 0; i < 40; ++i) {
      pages_.push_back(page_of(i));
      ids_.push_back(pages_.back()->id());
    }
    remote_ = stage_.system().spawn(remote_node, 0);
    store_ = stage_.system().spawn(make_page_store, cache_);
  }

  [[nodiscard]] std::deque<remote_state::question>& asked() {
    auto* self = caf::actor_cast<caf::abstract_actor*>(remote_);
    return dynamic_cast<caf::stateful_actor<remote_state>&>(*self).state.asked;
  }

  /// The remote answers the question that came first.
  void send_one() {
    page_cache all(std::size_t{1} << 30);
    for (const auto& p : pages_)
      all.put(p);
    auto first = std::move(asked().front());
    asked().pop_front();
    send(first.promise, pack(all, first.ids, first.packed).value());
  }

  void send(caf::typed_response_promise<page_batch> to, const page_batch& batch) {
    within(remote_, [=]() mutable { to.deliver(batch); });
  }

  answer<page_set> fetch(const hash_list& ids) {
    auto result = ask<page_set>(store_, fetch_atom::value, remote_, ids);
    pass(milliseconds(1));
    return result;
  }

  std::vector<page_ptr> pages_;
  hash_list ids_;
  std::shared_ptr<page_cache> cache_ = std::make_shared<page_cache>(std::size_t{1} << 20);
  caf::actor remote_;
  page_store_actor store_;
};

TEST_F(PageStore, AsksForBatchesOfFourUnderACreditOfSix) {
  const auto got = fetch(ids_);
  EXPECT_EQ(asked().size(), transfer_credit);
  for (const auto& one : asked())
    EXPECT_EQ(one.ids.size(), 4U);
  int batches = 0;
  for (; !asked().empty(); ++batches) {
    EXPECT_LE(asked().size(), transfer_credit);
    send_one();
  }
  EXPECT_EQ(batches, 10);
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().moved, 40U);
  for (const auto& p : pages_) {
    ASSERT_NE(got.value().find(p->id()), nullptr);
    EXPECT_TRUE(std::ranges::equal(got.value().find(p->id())->bytes(), p->bytes()));
  }
}

TEST_F(PageStore, HoldsWhatItsCacheLetsGo) {
  const auto got = fetch(ids_);
  while (!asked().empty())
    send_one();
  pages_.clear();  // 2.5 MiB; the cache keeps one.
  ASSERT_TRUE(got.is_success());
  for (const auto& id : ids_)
    EXPECT_NE(cache_->find(id), nullptr);
}

TEST_F(PageStore, AsksOnlyForWhatIsNotThere) {
  for (std::size_t i = 0; i < 39; ++i)
    cache_->put(pages_[i]);
  const auto got = fetch(ids_);
  ASSERT_EQ(asked().size(), 1U);
  EXPECT_THAT(asked().front().ids, ElementsAre(ids_[39]));
  send_one();
  EXPECT_EQ(got.value().moved, 1U);
  EXPECT_EQ(got.value().pages->size(), 40U);
}

TEST_F(PageStore, WithAllThereNobodyIsAsked) {
  for (const auto& p : pages_)
    cache_->put(p);
  const auto got = ask<page_set>(store_, fetch_atom::value, caf::actor{}, ids_);
  pass(milliseconds(1));
  EXPECT_EQ(got.value().moved, 0U);
}

TEST_F(PageStore, WithoutANodeMissingPagesAreRefused) {
  const auto got = ask<page_set>(store_, fetch_atom::value, caf::actor{}, ids_);
  pass(milliseconds(1));
  EXPECT_EQ(got.refusal().code, ec::not_found);
}

TEST_F(PageStore, APageThatIsNotWhatItsNameSaysIsRefused) {
  const auto got = fetch({ids_[0], ids_[1]});
  page_batch batch;
  for (const auto seed : {0, 7}) {
    const auto bytes = pages_[static_cast<std::size_t>(seed)]->bytes();
    batch.sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
    const auto* first = reinterpret_cast<const char*>(bytes.data());
    batch.bytes.insert(batch.bytes.end(), first, first + bytes.size());
  }
  send(asked().front().promise, batch);
  EXPECT_EQ(got.refusal().code, ec::protocol_error);
  EXPECT_THAT(got.refusal().message, HasSubstr(to_hex(ids_[1])));
  EXPECT_EQ(cache_->find(ids_[1]) ? pages_[1].use_count() : 0, 0) << "it was taken over";
}

TEST_F(PageStore, SizesThatTheBytesDoNotHaveAreRefused) {
  for (const std::uint32_t size : {65U, 65537U, 0xFFFFFFFFU}) {
    page_batch batch;
    batch.sizes = {size};
    batch.bytes.resize(64);
    const auto pages = unpack(batch, {ids_[0]});
    ASSERT_FALSE(pages) << size;
    EXPECT_EQ(pages.error().code, ec::protocol_error) << size;
  }
  EXPECT_FALSE(unpack({}, {ids_[0]})) << "fewer than asked for";
}

TEST_F(PageStore, TooManyAtOnceAreRefused) {
  const auto got = ask<page_batch>(store_, get_atom::value, hash_list(5), false);
  pass(milliseconds(1));
  EXPECT_EQ(got.refusal().code, ec::invalid_argument);
}

TEST_F(PageStore, AMissingPageIsNamed) {
  const auto got = ask<page_batch>(store_, get_atom::value, hash_list{ids_[3]}, false);
  pass(milliseconds(1));
  EXPECT_EQ(got.refusal().code, ec::not_found);
  EXPECT_THAT(got.refusal().message, HasSubstr(to_hex(ids_[3])));
}

TEST_F(PageStore, ANodeThatDiesEndsItsTransfersAndNoOthers) {
  const auto lost = fetch(ids_);
  send_one();
  simulation::cut_off(remote_);
  pass(milliseconds(1));
  EXPECT_EQ(lost.refusal().code, ec::service_unavailable);
  EXPECT_EQ(lost.count(), 1);
  const auto there = ask<page_set>(store_, fetch_atom::value, caf::actor{}, hash_list{ids_[0]});
  pass(milliseconds(1));
  EXPECT_TRUE(there.is_success()) << "what came before is kept";
}

TEST_F(PageStore, ANodeThatSaysNothingIsGivenUpAfterAWhile) {
  const auto lost = fetch(ids_);
  pass(milliseconds(19'000));
  EXPECT_FALSE(lost.is_there());
  pass(milliseconds(2'000));
  EXPECT_TRUE(lost.is_there());
  EXPECT_FALSE(lost.is_success());
  EXPECT_EQ(lost.count(), 1) << "six batches were late";
}

TEST_F(PageStore, ATransferThatFailedAsksForNoMore) {
  const auto lost = fetch(ids_);
  const auto first = asked().front().promise;
  asked().pop_front();
  send(first, {});
  EXPECT_EQ(lost.refusal().code, ec::protocol_error);
  const auto before = asked().size();
  send_one();
  EXPECT_EQ(asked().size(), before - 1);
  EXPECT_EQ(lost.count(), 1);
}

TEST_F(PageStore, APageThatSeveralWantIsAskedForOnce) {
  const auto first = fetch({ids_[0], ids_[1]});
  const auto second = fetch({ids_[1], ids_[2]});
  ASSERT_EQ(asked().size(), 2U);
  EXPECT_THAT(asked()[0].ids, ElementsAre(ids_[0], ids_[1]));
  EXPECT_THAT(asked()[1].ids, ElementsAre(ids_[2]));
  std::swap(asked()[0], asked()[1]);
  send_one();
  EXPECT_FALSE(second.is_there()) << "the other one's page is not there yet";
  send_one();
  ASSERT_TRUE(first.is_success());
  ASSERT_TRUE(second.is_success());
  EXPECT_NE(second.value().find(ids_[1]), nullptr);
  EXPECT_EQ(first.value().moved + second.value().moved, 3U);
}

TEST_F(PageStore, WhoWaitedForAnothersPageAsksItselfWhenThatFails) {
  const auto other = stage_.system().spawn(remote_node, 0);
  const auto first = ask<page_set>(store_, fetch_atom::value, other, hash_list{ids_[0]});
  pass(milliseconds(1));
  const auto second = fetch({ids_[0]});
  const auto third = fetch({ids_[0], ids_[1]});
  const auto nowhere = ask<page_set>(store_, fetch_atom::value, caf::actor{}, hash_list{ids_[0]});
  pass(milliseconds(1));
  ASSERT_EQ(asked().size(), 1U);
  EXPECT_THAT(asked()[0].ids, ElementsAre(ids_[1]));

  simulation::cut_off(other);
  pass(milliseconds(1));
  EXPECT_EQ(first.refusal().code, ec::service_unavailable);
  ASSERT_EQ(asked().size(), 2U);
  EXPECT_THAT(asked()[1].ids, ElementsAre(ids_[0])) << "once, for all three";
  send_one();
  send_one();
  EXPECT_TRUE(second.is_success());
  EXPECT_TRUE(third.is_success());
  EXPECT_TRUE(nowhere.is_success()) << "it knows nobody to ask, and need not";
}

TEST_F(PageStore, WhoKnowsNobodyToAskIsRefusedWhenTheOtherFails) {
  const auto first = fetch({ids_[0]});
  const auto nowhere = ask<page_set>(store_, fetch_atom::value, caf::actor{}, hash_list{ids_[0]});
  pass(milliseconds(1));
  EXPECT_FALSE(nowhere.is_there());
  send(asked().front().promise, {});
  EXPECT_EQ(first.refusal().code, ec::protocol_error);
  EXPECT_EQ(nowhere.refusal().code, ec::not_found);
  EXPECT_EQ(nowhere.count(), 1);
}

TEST_F(PageStore, OfASlowLineLittleIsAskedForAtOnceAndPacked) {
  const auto slow = fetch(ids_);
  EXPECT_FALSE(asked().front().packed) << "nothing is known of the line yet";
  for (int i = 0; i < 6; ++i) {
    pass(milliseconds(2000));
    send_one();
  }
  EXPECT_EQ(asked().size(), 1U) << "128 KiB a second: the next batch takes two seconds";
  EXPECT_TRUE(asked().front().packed);
  const auto other = fetch({page_of(77)->id()});
  EXPECT_EQ(asked().size(), 2U) << "nobody waits for the end of another's transfer";
  pages_.push_back(page_of(77));
  while (!asked().empty())
    send_one();
  EXPECT_TRUE(slow.is_success());
  EXPECT_TRUE(other.is_success());
}

TEST_F(PageStore, AQuickLineIsAskedForPagesAsTheyAre) {
  const auto got = fetch(ids_);
  while (!asked().empty()) {
    EXPECT_FALSE(asked().front().packed);
    send_one();
  }
  EXPECT_TRUE(got.is_success());
}

/// Results of this process whose pages lie with other nodes.
class PagesElsewhere : public PageStore {
protected:
  PagesElsewhere() {
    other_ = stage_.system().spawn(make_far, 0);
    for (const auto& p : pages_)
      far().pages.emplace(p->id(), p);
  }

  far_state& far() { return simulation::state_of<far_state>(other_); }

  void say_where(const caf::actor& node, const hash_list& ids) {
    tell(caf::actor_cast<caf::actor>(store_), lies_at_atom::value, node, ids);
  }

  answer<page_set> fetch_own(const hash_list& ids) {
    auto result =
      ask<page_set>(store_, fetch_atom::value, caf::actor_cast<caf::actor>(store_), ids);
    pass(milliseconds(1));
    return result;
  }

  double own_rate() {
    const auto rate = ask<double>(store_, rate_atom::value, caf::actor_cast<caf::actor>(store_));
    pass(milliseconds(1));
    return rate.value();
  }

  void set_rate(const caf::actor& node, double bytes_s) {
    simulation::state_of<page_store_state>(store_).lines.at(node.address()).rate = bytes_s;
  }

  caf::actor other_;
};

TEST_F(PagesElsewhere, EachComesFromWhereItLies) {
  say_where(remote_, {ids_[2], ids_[1]});
  say_where(other_, {ids_[3], ids_[4]});
  cache_->put(pages_[5]);
  const auto got = fetch_own({ids_[1], ids_[2], ids_[3], ids_[4], ids_[5]});
  EXPECT_FALSE(got.is_there()) << "the first node has not answered";
  ASSERT_EQ(asked().size(), 1U);
  EXPECT_THAT(asked().front().ids, ElementsAre(ids_[1], ids_[2]));
  send_one();
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().moved, 4U);
  EXPECT_EQ(got.value().pages->size(), 5U);
  EXPECT_EQ(far().sent, 2U);
}

TEST_F(PagesElsewhere, WhatLiesNowhereIsMissing) {
  say_where(other_, {ids_[3]});
  EXPECT_EQ(fetch_own({ids_[2], ids_[3]}).refusal().code, ec::not_found);
  EXPECT_EQ(fetch_own({ids_[2]}).refusal().code, ec::not_found);
}

TEST_F(PagesElsewhere, WhatANodeForgotIsMissingOnce) {
  say_where(other_, {ids_[3]});
  say_where(remote_, {ids_[1]});
  far().forgot = true;
  const auto got = fetch_own({ids_[1], ids_[3]});
  send_one();
  EXPECT_EQ(got.refusal().code, ec::not_found);
  EXPECT_EQ(got.count(), 1);
}

TEST_F(PagesElsewhere, ANodeThatIsGoneHasNone) {
  say_where(other_, {ids_[3]});
  simulation::cut_off(other_);
  pass(milliseconds(1));
  EXPECT_EQ(fetch_own({ids_[3]}).refusal().code, ec::not_found);
  EXPECT_TRUE(simulation::state_of<page_store_state>(store_).places.empty());
}

TEST_F(PagesElsewhere, OnlyThisProcessSaysWhere) {
  caf::anon_send(store_, lies_at_atom::value, other_, hash_list{ids_[3]});
  pass(milliseconds(1));
  EXPECT_EQ(fetch_own({ids_[3]}).refusal().code, ec::not_found);
}

TEST_F(PagesElsewhere, TheSlowestLineCounts) {
  EXPECT_EQ(own_rate(), 0);
  say_where(remote_, {ids_[1]});
  say_where(other_, {ids_[3]});
  EXPECT_EQ(own_rate(), 0) << "nothing is known of them";
  set_rate(other_, 4e6);
  EXPECT_EQ(own_rate(), 4e6);
  set_rate(remote_, 1e6);
  EXPECT_EQ(own_rate(), 1e6);
}

TEST_F(PagesElsewhere, TheOldestAreForgotten) {
  say_where(other_, {ids_[0]});
  for (std::size_t i = 0; i < places_kept; ++i)
    say_where(other_, {ids_[1]});
  EXPECT_EQ(fetch_own({ids_[0]}).refusal().code, ec::not_found);
  EXPECT_TRUE(fetch_own({ids_[1]}).is_success());
}

TEST(PageBatch, PackedPagesAreSmallerAndTheSame) {
  std::vector<double> values(max_page_bytes / sizeof(double));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = 1e6 + static_cast<double>(i) / 8;
  page_cache cache(std::size_t{1} << 20);
  const auto even = page::from_bytes(std::as_bytes(std::span(values)));
  const auto odd = page_of(5, 13);  // Less than two numbers.
  cache.put(even);
  cache.put(odd);
  const hash_list ids{even->id(), odd->id()};
  const auto batch = pack(cache, ids, true).value();
  EXPECT_TRUE(batch.packed);
  EXPECT_LT(batch.bytes.size(), max_page_bytes / 4);
  const auto pages = unpack(batch, ids).value();
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_TRUE(std::ranges::equal(pages[0]->bytes(), even->bytes()));
  EXPECT_TRUE(std::ranges::equal(pages[1]->bytes(), odd->bytes()));
}

TEST(PageBatch, WhatCannotBeMadeSmallerIsSentAsItIs) {
  std::mt19937_64 random(1);
  std::vector<std::uint64_t> noise(1000);
  std::ranges::generate(noise, random);
  page_cache cache(std::size_t{1} << 20);
  const auto p = page::from_bytes(std::as_bytes(std::span(noise)));
  cache.put(p);
  const auto batch = pack(cache, {p->id()}, true).value();
  EXPECT_FALSE(batch.packed);
  EXPECT_EQ(batch.bytes.size(), 8000U);
}

TEST(PageBatch, DamagedOrOverlongPackedBytesAreRefused) {
  page_cache cache(std::size_t{1} << 20);
  const auto p = page_of(1);
  cache.put(p);
  const auto good = pack(cache, {p->id()}, true).value();
  ASSERT_TRUE(good.packed);
  auto cut = good;
  cut.bytes.resize(good.bytes.size() / 2);
  auto shorter = good;
  shorter.sizes = {100};  // It unpacks to more.
  auto longer = good;
  longer.sizes = {max_page_bytes + 1};
  auto empty = good;
  empty.bytes.clear();
  for (const auto& bad : {cut, shorter, longer, empty})
    EXPECT_EQ(unpack(bad, {p->id()}).error().code, ec::protocol_error);
  const page_batch huge{std::vector<std::uint32_t>(9, max_page_bytes), good.bytes, true};
  EXPECT_EQ(unpack(huge, hash_list(9)).error().code, ec::protocol_error);
}

TEST(PageCache, KeepsWhatWasUsedLast) {
  page_cache cache(3 * max_page_bytes);
  std::vector<hash128> ids;
  for (unsigned i = 0; i < 3; ++i) {
    cache.put(page_of(i));
    ids.push_back(page_of(i)->id());
  }
  ASSERT_NE(cache.find(ids[0]), nullptr);  // Now it was used after the second.
  cache.put(page_of(3));
  EXPECT_NE(cache.find(ids[0]), nullptr);
  EXPECT_EQ(cache.find(ids[1]), nullptr);
  EXPECT_NE(cache.find(ids[2]), nullptr);
}

TEST(PageCache, FindsWhatSomebodyHoldsWhateverItsBudget) {
  page_cache cache(0);
  const auto held = page_of(1);
  cache.put(held);
  cache.put(page_of(2));
  EXPECT_EQ(cache.find(held->id()), held);
  EXPECT_EQ(cache.find(page_of(2)->id()), nullptr);
}

}  // namespace
}  // namespace tedit::actors
